package org.u2sa.device;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.u2sa.device.port.Sonar;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the nearest strong echo of each ping of a scanning sonar, several pings as one scan
 * (thesis 4.1.1.1). Out: scans.
 */
public final class SonarSensor extends DeviceSensor<Sonar.Ping> {
  private static final SensorKind<Sonar> KIND =
      new SensorKind<>(
          "SonarSensor",
          Sonar.class,
          new Devices.Usual("sonar", "SONAR", "PING360", "serial:/dev/ttyUSB0?baud=115200"),
          Channels.SCANS,
          50.0, // Hz
          4.0); // s

  private record Variables(
      @Variable(min = 1, max = 255, ifAbsent = 100)
          @Description("Minimum strength of an echo that counts as an object; 255 is full scale.")
          int threshold,
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.75)
          @Description("Minimum range of the scans: closer echoes are transducer ringing.")
          double nearest,
      @Variable(min = 1, max = 1000, ifAbsent = 8) @Description("Pings in each published scan.")
          int pingsPerScan) {}

  private final MountingPose mounted = settings(MountingPose.class).get();
  private final Settings<Variables> tuning = settings(Variables.class);
  private final List<RangeScan.Beam> beams = new ArrayList<>();
  private long beganMicros;
  private long lastMicros;
  private double reachM;

  public SonarSensor(ServiceContext context) {
    super(context, KIND);
  }

  public SonarSensor(ServiceContext context, Sonar sonar) {
    super(context, KIND, sonar);
  }

  @Override
  protected Stream<RangeScan> messages(Sonar.Ping ping) {
    if (beams.isEmpty()) {
      beganMicros = ping.measuredAtMicros();
      reachM = ping.reachM();
    }
    lastMicros = ping.measuredAtMicros();
    reachM = Math.min(reachM, ping.reachM());
    beams.add(new RangeScan.Beam(ping.bearingRad(), nearest(ping)));
    if (beams.size() < tuning.get().pingsPerScan()) {
      return Stream.empty();
    }
    try {
      return Stream.of(scan());
    } finally {
      beams.clear(); // even if the scan rejects a value: the next one starts without these pings
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

  private RangeScan scan() {
    int gaps = Math.max(1, beams.size() - 1);
    RangeScan scan =
        mounted
            .placing(new RangeScan().sensorName(sensorName()))
            .minRange(Math.min(tuning.get().nearest(), reachM))
            .maxRange(reachM)
            .timeIncrement((lastMicros - beganMicros) * 1e-6 / gaps)
            .beams(List.copyOf(beams));
    scan.timestamp(beganMicros);
    return scan;
  }
}
