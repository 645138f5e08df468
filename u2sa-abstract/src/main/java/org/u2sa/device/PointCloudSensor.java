package org.u2sa.device;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.u2sa.device.port.PointScanner;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the view of a 3-D lidar or depth camera as one point cloud in BODY, once per scan
 * (thesis 3.2.3.6, figure 10): the points at the height of obstacles, the nearest of each cell;
 * empty if there are none. Out: sensed-objects; the object's own place is the point nearest to the
 * scanner, or the scanner's.
 */
public final class PointCloudSensor extends DeviceSensor<PointScanner.Cloud> {
  private static final SensorKind<PointScanner> KIND =
      new SensorKind<>(
          "PointCloudSensor",
          PointScanner.class,
          new Devices.Usual("3-D scanner", "SCANNER", "VLP-16", "udp:2368"),
          Channels.SENSED_OBJECTS,
          50.0, // Hz
          1.0); // s

  private record Variables(
      @Variable(unit = "m", min = -1_000, max = 1_000, ifAbsent = 0.1)
          @Description(
              "Minimum height above the vehicle's reference point; lower points are ground.")
          double minHeight,
      @Variable(unit = "m", min = -1_000, max = 1_000, ifAbsent = 2)
          @Description(
              "Maximum height above the vehicle's reference point; the vehicle passes under higher points.")
          double maxHeight,
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.5)
          @Description("Minimum range from the scanner; closer points are the vehicle itself.")
          double nearest,
      @Variable(unit = "m", min = 0.1, max = 1_000, ifAbsent = 30)
          @Description("Maximum range from the scanner; farther points are ignored.")
          double farthest,
      @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.2)
          @Description("Edge of the cubic cells; the nearest point of each is published.")
          double cell,
      @Variable(min = 1, max = 10_000, ifAbsent = 1_000)
          @Description("Maximum number of points in a message; the farthest are left out.")
          int maxPoints) {}

  private record Cell(long x, long y, long z) {}

  private record Seen(double rangeM, Point body) {}

  private final MountingPose.Turn mounted = settings(MountingPose.class).get().turn();
  private final Settings<Variables> tuning = settings(Variables.class);

  public PointCloudSensor(ServiceContext context) {
    super(context, KIND);
  }

  public PointCloudSensor(ServiceContext context, PointScanner scanner) {
    super(context, KIND, scanner);
  }

  @Override
  protected Stream<PointCloud> messages(PointScanner.Cloud cloud) {
    List<Point> points = thinned(cloud.points(), tuning.get());
    Point first = points.isEmpty() ? mounted.toBody(Point.ORIGIN) : points.get(0);
    PointCloud seen = new PointCloud().points(points);
    seen.uid(sensorName())
        .referenceFrame(ReferenceFrame.BODY)
        .x(first.x())
        .y(first.y())
        .z(first.z())
        .level(ObjectLevel.AVOID_ALWAYS)
        .sensorName(sensorName());
    return Stream.of(seen);
  }

  private List<Point> thinned(List<Point> points, Variables now) {
    List<Seen> all = new ArrayList<>();
    for (Point point : points) {
      double rangeM = point.distance();
      if (rangeM >= now.nearest() && rangeM <= now.farthest()) {
        Point body = mounted.toBody(point);
        if (-body.z() >= now.minHeight() && -body.z() <= now.maxHeight()) {
          all.add(new Seen(rangeM, body));
        }
      }
    }
    all.sort(Comparator.comparingDouble(Seen::rangeM));
    Set<Cell> taken = new HashSet<>();
    List<Point> kept = new ArrayList<>();
    for (Seen seen : all) {
      if (kept.size() == now.maxPoints()) {
        break;
      }
      if (taken.add(cell(seen.body(), now.cell()))) {
        kept.add(seen.body());
      }
    }
    return kept;
  }

  private static Cell cell(Point at, double edgeM) {
    return new Cell(
        (long) Math.floor(at.x() / edgeM),
        (long) Math.floor(at.y() / edgeM),
        (long) Math.floor(at.z() / edgeM));
  }
}
