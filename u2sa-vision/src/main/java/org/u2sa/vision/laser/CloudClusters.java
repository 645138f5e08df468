package org.u2sa.vision.laser;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Detects objects in the point clouds of 3-D lidars and depth cameras, such as buoys on open water
 * (thesis 4.2.1.1): points near each other in plan view, at any height (Euclidean clustering: Rusu,
 * Semantic 3D Object Maps, 2009). In and out: sensed-objects in BODY; out as Circle without a type,
 * which a camera can provide. The World Modeler keeps them when the lidar's few beams miss them.
 */
public final class CloudClusters extends EventDrivenService {
  private record Variables(
      @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.6)
          @Description("Maximum horizontal distance between neighbouring points of one object.")
          double gap,
      @Variable(min = 1, max = 1000, ifAbsent = 2)
          @Description("Minimum number of points of an object; fewer count as noise.")
          int minPoints,
      @Variable(unit = "m", min = 0.05, max = 100, ifAbsent = 2)
          @Description("Maximum extent of an object; larger ones are left to the point cloud.")
          double largest,
      @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.3)
          @Description("Minimum radius of the circle published, because the far side is hidden.")
          double minRadius) {}

  private final Variables settings;
  private long clouds;

  public CloudClusters(ServiceContext context) {
    super(context, ServiceRole.EXTEROCEPTIVE_SENSOR, "CloudClusters");
    settings = settings(Variables.class).get();
    registerPublisher(Channels.SENSED_OBJECTS);
    subscribe(Channels.SENSED_OBJECTS, this::onObject);
  }

  private void onObject(ObjectDescription object) {
    if (object instanceof PointCloud cloud
        && cloud.isScan()
        && cloud.referenceFrame().equals(ReferenceFrame.BODY)) {
      onCloud(cloud);
    }
  }

  private void onCloud(PointCloud cloud) {
    int number = 0;
    for (List<Point> group : groups(cloud.points())) {
      Circle circle = around(group);
      if (group.size() >= settings.minPoints() && circle.radius() <= 0.5 * settings.largest()) {
        number++;
        circle
            .uid(cloud.sensorName() + " object " + number)
            .referenceFrame(ReferenceFrame.BODY)
            .sensorName(
                cloud.sensorName() + SensorParts.OBJECTS); // differs from the scanner's name
        circle.timestamp(cloud.timestamp().orElseThrow());
        publish(Channels.SENSED_OBJECTS, circle);
      }
    }
    clouds++;
    remark("SEEN", String.format("%d clouds; last %d objects", clouds, number));
  }

  private List<List<Point>> groups(List<Point> points) {
    List<Point> left = new ArrayList<>(points);
    List<List<Point>> groups = new ArrayList<>();
    while (!left.isEmpty()) {
      List<Point> group = new ArrayList<>();
      Deque<Point> open = new ArrayDeque<>();
      open.add(left.remove(left.size() - 1));
      while (!open.isEmpty()) {
        Point at = open.remove();
        group.add(at);
        left.removeIf(
            each -> {
              boolean isNear = Math.hypot(each.x() - at.x(), each.y() - at.y()) <= settings.gap();
              if (isNear) {
                open.add(each);
              }
              return isNear;
            });
      }
      groups.add(group);
    }
    return groups;
  }

  /** Circle behind the points, with the nearest point on its edge. */
  private Circle around(List<Point> group) {
    double x = group.stream().mapToDouble(Point::x).average().orElseThrow();
    double y = group.stream().mapToDouble(Point::y).average().orElseThrow();
    double z = group.stream().mapToDouble(Point::z).average().orElseThrow();
    double nearest =
        group.stream().mapToDouble(at -> Math.hypot(at.x(), at.y())).min().orElseThrow();
    double extent =
        group.stream().mapToDouble(at -> Math.hypot(at.x() - x, at.y() - y)).max().orElseThrow();
    double radius = Math.max(settings.minRadius(), extent);
    double range = Math.max(1e-3, Math.hypot(x, y));
    double scale = (nearest + radius) / range;
    Circle circle = new Circle().radius(radius);
    circle.x(scale * x).y(scale * y).z(z);
    circle.motion().sigma(Point.of(0.15, 0.15, 0.0));
    return circle;
  }
}
