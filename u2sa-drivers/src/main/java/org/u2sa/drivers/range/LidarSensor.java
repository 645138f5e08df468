package org.u2sa.drivers.range;

import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.LinkWatch;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * A scanning laser: each turn beam by beam, with those that saw nothing, and where on the vehicle
 * it sits (thesis 3.2.3.6, 4.1.1.1). Out: scans.
 */
public final class LidarSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 100.0;
  private static final double SILENT_AFTER_S = 1.0;
  private static final String HOKUYO = "hokuyo";

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB0?baud=115200&dtr=off")
          .describedAs(
              "Where the laser is: serial:DEVICE?baud=N or tcp:HOST:PORT; an RPLIDAR A1's USB adapter runs the motor with dtr=off.");

  static final VariableDeclaration<String> LIDAR =
      VariableDeclaration.text("LIDAR")
          .oneOf("rplidar", HOKUYO)
          .ifAbsent("rplidar")
          .describedAs("Protocol: Slamtec's RPLIDAR, or SCIP 2 as Hokuyo speaks it.");

  static final VariableDeclaration<Integer> PUBLISH_EVERY =
      VariableDeclaration.integer("PUBLISH EVERY")
          .range(Range.of(1, 1000))
          .ifAbsent(1)
          .describedAs("Publish every Nth scan.");

  static final VariableDeclaration<Double> NEAREST =
      VariableDeclaration.number("NEAREST", "m")
          .range(Range.of(0.0, 100.0))
          .ifAbsent(0.1)
          .describedAs(
              "What is nearer to the laser is the vehicle itself: the scan's minRange, unless the laser's own is more.");

  static final VariableDeclaration<Double> FARTHEST =
      VariableDeclaration.number("FARTHEST", "m")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(100.0)
          .describedAs(
              "What is farther does not count: the scan's maxRange, unless the laser's own is less.");

  private final Scanner scanner;
  private final LinkWatch watch;
  private final MountingPose mounted;
  private final int publishEvery;
  private final double nearestM;
  private final double farthestM;
  private long scannedMicros = Scanner.NONE.endedAtMicros();
  private long scans;

  /** Called by the launcher: opens the link that CONNECTION names. */
  public LidarSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Over a link that the host made, whatever CONNECTION says. */
  public LidarSensor(ServiceContext context, ByteLink link) {
    this(context, Optional.of(link));
  }

  private LidarSensor(ServiceContext context, Optional<ByteLink> given) {
    super(context, "LidarSensor", STEPS_PER_S);
    registerPublisher(Channels.SCANS);
    mounted = MountingPose.read(this);
    publishEvery = getVariable(PUBLISH_EVERY);
    nearestM = getVariable(NEAREST);
    farthestM = getVariable(FARTHEST);
    String address = getVariable(CONNECTION);
    ByteLink link =
        given.orElseGet(
            () ->
                ByteLinks.open(
                    address,
                    context.clock(),
                    path -> context.configuration().resolve(path.toString())));
    watch = new LinkWatch(this, "the laser", link, SILENT_AFTER_S);
    scanner = getVariable(LIDAR).equals(HOKUYO) ? new Hokuyo(link) : new Rplidar(link);
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    watch.look(now);
    Scanner.Reading reading = scanner.read(now);
    watch.malformed(scanner.malformed());
    String said = scanner.trouble();
    if (!said.isEmpty()) {
      trouble("the laser says: " + said);
    }
    if (reading.endedAtMicros() != scannedMicros) {
      scannedMicros = reading.endedAtMicros();
      watch.heard(now);
      if (scans++ % publishEvery == 0) {
        publish(reading.beams());
      }
    }
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
