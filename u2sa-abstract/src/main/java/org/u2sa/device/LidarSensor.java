package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the scans of a lidar, including beams without an echo, with its mounting on the vehicle
 * (thesis 3.2.3.6, 4.1.1.1). Out: scans.
 */
public final class LidarSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 100.0;
  private static final double SILENT_AFTER_S = 1.0;

  private static final Devices.Usual USUAL = // works for an RPLIDAR A1 with USB adapter
      new Devices.Usual("laser", "LIDAR", "rplidar", "serial:/dev/ttyUSB0?baud=115200&dtr=off");

  private record Tuning(
      @Variable(min = 1, max = 1000, ifAbsent = 1, text = "Publish every Nth scan.")
          int publishEvery,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 0.1,
              text = "Nearer echoes are of the vehicle itself: least minRange of the scans.")
          double nearest,
      @Variable(
              unit = "m",
              min = 0.1,
              max = 1000,
              ifAbsent = 100,
              text = "Farther echoes do not count: largest maxRange of the scans.")
          double farthest) {}

  private final LaserScanner scanner;
  private final DeviceReader<LaserScanner.Scan> reader;
  private final MountingPose mounted;
  private final Settings<Tuning> tuning;
  private long scans;

  /** Launcher constructor: opens the configured lidar. */
  public LidarSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given lidar, e.g. a simulated one. */
  public LidarSensor(ServiceContext context, LaserScanner scanner) {
    this(context, Optional.of(scanner));
  }

  private LidarSensor(ServiceContext context, Optional<LaserScanner> made) {
    super(context, "LidarSensor", STEPS_PER_S);
    registerPublisher(Channels.SCANS);
    mounted = settings(MountingPose.class).get();
    tuning = settings(Tuning.class);
    scanner = Devices.open(LaserScanner.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the laser", scanner, SILENT_AFTER_S);
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .filter(scan -> scans++ % tuning.get().publishEvery() == 0)
        .ifPresent(scan -> publish(scan.beams()));
  }

  private void publish(RangeScan scan) {
    publish(
        Channels.SCANS,
        scan.sensorName(sensorName())
            .x(mounted.x())
            .y(mounted.y())
            .z(mounted.z())
            .phi(mounted.roll())
            .theta(mounted.pitch())
            .psi(mounted.yaw())
            .minRange(Math.max(scan.minRange(), tuning.get().nearest()))
            .maxRange(Math.min(scan.maxRange(), tuning.get().farthest())));
  }

  @Override
  protected void release() {
    scanner.close();
  }
}
