package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.LinkWatch;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.PointCloud;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * A scanning laser: what one turn saw, as a cloud of points in BODY (thesis 3.2.3.6, 4.1.1.1). Out:
 * sensed-objects, for scans that saw anything.
 */
public final class LidarSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 100.0;
  private static final double SILENT_AFTER_S = 1.0;
  private static final String HOKUYO = "hokuyo";

  static final Variable<String> CONNECTION =
      Variable.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB0?baud=115200&dtr=off")
          .describedAs(
              "Where the laser is: serial:DEVICE?baud=N or tcp:HOST:PORT; an RPLIDAR A1's USB adapter runs the motor with dtr=off.");

  static final Variable<String> LIDAR =
      Variable.text("LIDAR")
          .oneOf("rplidar", HOKUYO)
          .ifAbsent("rplidar")
          .describedAs("Protocol: Slamtec's RPLIDAR, or SCIP 2 as Hokuyo speaks it.");

  static final Variable<Integer> PUBLISH_EVERY =
      Variable.integer("PUBLISH EVERY")
          .range(Range.of(1, 1000))
          .ifAbsent(1)
          .describedAs("Each how manieth scan is published.");

  static final Variable<Double> NEAREST =
      Variable.number("NEAREST", "m")
          .range(Range.of(0.0, 100.0))
          .ifAbsent(0.1)
          .describedAs("What is nearer to the laser is the vehicle itself.");

  static final Variable<Double> FARTHEST =
      Variable.number("FARTHEST", "m")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(100.0)
          .describedAs("What is farther is left out.");

  private final Scanner scanner;
  private final LinkWatch watch;
  private final MountingPose.Turn mounted;
  private final int publishEvery;
  private final double nearestM;
  private final double farthestM;
  private long scannedMicros = Scanner.NONE.measuredAtMicros();
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
    mounted = MountingPose.read(this).turn();
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
    if (reading.measuredAtMicros() != scannedMicros) {
      scannedMicros = reading.measuredAtMicros();
      watch.heard(now);
      if (scans++ % publishEvery == 0) {
        publish(reading);
      }
    }
  }

  private void publish(Scanner.Reading reading) {
    List<Point> points = new ArrayList<>(reading.points().size());
    Point sum = Point.ORIGIN;
    for (Point seen : reading.points()) {
      double range = seen.distance();
      if (range >= nearestM && range <= farthestM) {
        Point point = mounted.toBody(seen);
        points.add(point);
        sum = sum.plus(point);
      }
    }
    if (points.isEmpty()) {
      return; // a cloud has at least one point
    }
    int count = points.size();
    PointCloud cloud =
        new PointCloud()
            .uid(sensorName())
            .referenceFrame(ReferenceFrame.BODY)
            .x(sum.x() / count)
            .y(sum.y() / count)
            .z(sum.z() / count)
            .points(points);
    cloud.timestamp(reading.measuredAtMicros());
    publish(Channels.SENSED_OBJECTS, cloud);
  }

  @Override
  protected void release() {
    scanner.close();
  }
}
