package org.u2sa.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.Sonar;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the nearest strong echo of each ping of a scanning sonar; batches pings into one scan,
 * including those without an echo (thesis 4.1.1.1). Out: scans.
 */
public final class SonarSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 50.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual("sonar", "SONAR", "PING360", "serial:/dev/ttyUSB0?baud=115200");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.1,
              max = 60,
              ifAbsent = 4,
              text = "Time without a readable ping after which the sonar counts as silent.")
          double timeout,
      @Variable(
              min = 1,
              max = 255,
              ifAbsent = 100,
              text = "Least strength of an echo that counts as an object; 255 is full scale.")
          int threshold,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 0.75,
              text = "Nearer echoes are of the transducer itself: minRange of the scans.")
          double nearest,
      @Variable(min = 1, max = 1000, ifAbsent = 8, text = "Pings in each published scan.")
          int pingsPerScan) {}

  private final Sonar sonar;
  private final DeviceReader<Sonar.Ping> reader;
  private final MountingPose mounted;
  private final Settings<Tuning> tuning;
  private final List<RangeScan.Beam> beams = new ArrayList<>();
  private long beganMicros;
  private long lastMicros;
  private double reachM;

  /** Launcher constructor: opens the configured sonar. */
  public SonarSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given sonar, e.g. a simulated one. */
  public SonarSensor(ServiceContext context, Sonar sonar) {
    this(context, Optional.of(sonar));
  }

  private SonarSensor(ServiceContext context, Optional<Sonar> made) {
    super(context, "SonarSensor", STEPS_PER_S);
    registerPublisher(Channels.SCANS);
    mounted = settings(MountingPose.class).get();
    tuning = settings(Tuning.class);
    sonar = Devices.open(Sonar.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the sonar", sonar, tuning.get().timeout());
  }

  @Override
  protected void step(double nowS) {
    reader.next(clock().micros()).ifPresent(this::use);
  }

  private void use(Sonar.Ping ping) {
    if (beams.isEmpty()) {
      beganMicros = ping.measuredAtMicros();
      reachM = ping.reachM();
    }
    lastMicros = ping.measuredAtMicros();
    reachM = Math.min(reachM, ping.reachM());
    beams.add(new RangeScan.Beam(ping.bearingRad(), nearest(ping)));
    if (beams.size() >= tuning.get().pingsPerScan()) {
      publishScan();
      beams.clear();
    }
  }

  private OptionalDouble nearest(Sonar.Ping ping) {
    for (int sample = 0; sample < ping.strengths().length; sample++) {
      boolean isStrong = (ping.strengths()[sample] & 0xFF) >= tuning.get().threshold();
      if (isStrong && ping.rangeM(sample) >= tuning.get().nearest()) {
        return OptionalDouble.of(ping.rangeM(sample));
      }
    }
    return OptionalDouble.empty();
  }

  private void publishScan() {
    int gaps = Math.max(1, beams.size() - 1);
    RangeScan scan =
        new RangeScan()
            .sensorName(sensorName())
            .x(mounted.x())
            .y(mounted.y())
            .z(mounted.z())
            .phi(mounted.roll())
            .theta(mounted.pitch())
            .psi(mounted.yaw())
            .minRange(Math.min(tuning.get().nearest(), reachM))
            .maxRange(reachM)
            .timeIncrement((lastMicros - beganMicros) * 1e-6 / gaps)
            .beams(List.copyOf(beams));
    scan.timestamp(beganMicros);
    publish(Channels.SCANS, scan);
  }

  @Override
  protected void release() {
    sonar.close();
  }
}
