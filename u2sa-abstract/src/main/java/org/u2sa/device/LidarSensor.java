package org.u2sa.device;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the scans of a laser, beams without an echo included, with its place on the vehicle
 * (thesis 3.2.3.6, 4.1.1.1). Out: scans.
 */
public final class LidarSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 100.0;
  private static final double SILENT_AFTER_S = 1.0;

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB0?baud=115200&dtr=off")
          .describedAs(
              "Address of the laser, as its driver takes it (docs/drivers/links.md); an RPLIDAR A1's USB adapter runs the motor with dtr=off.");

  static final VariableDeclaration<String> LIDAR =
      VariableDeclaration.text("LIDAR")
          .ifAbsent("rplidar")
          .describedAs("Kind of laser: the name of a driver.");

  static final VariableDeclaration<Integer> PUBLISH_EVERY =
      VariableDeclaration.integer("PUBLISH EVERY")
          .range(Range.of(1, 1000))
          .ifAbsent(1)
          .describedAs("Publish every Nth scan.");

  static final VariableDeclaration<Double> NEAREST =
      VariableDeclaration.number("NEAREST", "m")
          .range(Range.of(0.0, 100.0))
          .ifAbsent(0.1)
          .describedAs("Nearer echoes are of the vehicle itself: least minRange of the scans.");

  static final VariableDeclaration<Double> FARTHEST =
      VariableDeclaration.number("FARTHEST", "m")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(100.0)
          .describedAs("Farther echoes do not count: largest maxRange of the scans.");

  private final LaserScanner scanner;
  private final DeviceReader<LaserScanner.Scan> reader;
  private final MountingPose mounted;
  private final int publishEvery;
  private final double nearestM;
  private final double farthestM;
  private long scans;

  /** Called by the launcher: the laser is the one that the configuration names. */
  public LidarSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** With a laser that the host made: a simulated one. */
  public LidarSensor(ServiceContext context, LaserScanner scanner) {
    this(context, Optional.of(scanner));
  }

  private LidarSensor(ServiceContext context, Optional<LaserScanner> made) {
    super(context, "LidarSensor", STEPS_PER_S);
    registerPublisher(Channels.SCANS);
    mounted = MountingPose.read(this);
    publishEvery = getVariable(PUBLISH_EVERY);
    nearestM = getVariable(NEAREST);
    farthestM = getVariable(FARTHEST);
    getVariable(CONNECTION);
    scanner = Devices.open(LaserScanner.class, LIDAR, context, made);
    reader = new DeviceReader<>(this, "the laser", scanner, SILENT_AFTER_S);
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .filter(scan -> scans++ % publishEvery == 0)
        .ifPresent(scan -> publish(scan.beams()));
  }

  private void publish(RangeScan scan) {
    publish(
        Channels.SCANS,
        scan.sensorName(sensorName())
            .x(mounted.position().x())
            .y(mounted.position().y())
            .z(mounted.position().z())
            .phi(mounted.roll())
            .theta(mounted.pitch())
            .psi(mounted.yaw())
            .minRange(Math.max(scan.minRange(), nearestM))
            .maxRange(Math.min(scan.maxRange(), farthestM)));
  }

  @Override
  protected void release() {
    scanner.close();
  }
}
