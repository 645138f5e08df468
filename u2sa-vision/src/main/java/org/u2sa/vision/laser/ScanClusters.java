package org.u2sa.vision.laser;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.shape.Circle;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.vision.ground.AttitudeHistory;

/**
 * Detects objects in the scans of range finders (thesis 4.1.1.1): round clusters of the right size
 * as a fitted circle, other clusters of limited size as the circle around their echoes. In: scans;
 * state, for roll and pitch. Out: sensed-objects in BODY, as Circle without a type, which a camera
 * can provide. Free space is mapped from the scans themselves.
 */
public final class ScanClusters extends EventDrivenService {
  private static final double TIGHT = 3.0; // max. fit residual, in multiples of the range noise

  private final ClusterVariables settings;
  private final Clusters clusters;
  private final AttitudeHistory attitudes = new AttitudeHistory();
  private long scans;

  public ScanClusters(ServiceContext context) {
    super(context, ServiceRole.EXTEROCEPTIVE_SENSOR, "ScanClusters");
    settings = settings(ClusterVariables.class).get();
    clusters = new Clusters(settings);
    registerPublisher(Channels.SENSED_OBJECTS);
    subscribe(Channels.STATE, attitudes::add);
    subscribe(Channels.SCANS, this::onScan);
  }

  private void onScan(RangeScan scan) {
    if (!scan.timestamp().isPresent() || !scan.referenceFrame().equals(ReferenceFrame.BODY)) {
      trouble("a scan from " + scan.sensorName() + " has no time, or is not in BODY");
      return;
    }
    long micros = scan.timestamp().orElseThrow();
    Rotation level = Rotation.nedFromFrd(attitudes.roll(micros), attitudes.pitch(micros), 0.0);
    List<List<Point>> groups = clusters.of(scan, point -> isGround(point, level));
    int number = 0;
    for (List<Point> group : groups) {
      Optional<Circle> object = object(group);
      if (object.isPresent()) {
        number++;
        publish(Channels.SENSED_OBJECTS, named(object.get(), scan, number));
      }
    }
    scans++;
    remark("SEEN", String.format("%d scans; last %d objects", scans, number));
  }

  private boolean isGround(Point body, Rotation level) {
    Point turned = level.times(Point.of(body.x(), -body.y(), body.z()));
    return turned.z() > settings.groundBelow() - settings.lowest();
  }

  private static ObjectDescription named(Circle object, RangeScan scan, int number) {
    String name =
        scan.sensorName() + SensorParts.OBJECTS; // not the scanner's own name: scans carry no types
    object
        .uid(scan.sensorName() + " object " + number)
        .referenceFrame(ReferenceFrame.BODY)
        .sensorName(name);
    object.timestamp(scan.timestamp().orElseThrow());
    return object;
  }

  private Optional<Circle> object(List<Point> group) {
    Point first = group.get(0);
    Point last = group.get(group.size() - 1);
    double extent = 0.0;
    for (Point point : group) {
      extent = Math.max(extent, Math.max(point.distanceTo(first), point.distanceTo(last)));
    }
    if (group.size() < settings.minEchoes() || extent > settings.largest()) {
      return Optional.empty();
    }
    double height = group.stream().mapToDouble(Point::z).average().orElseThrow();
    Optional<CircleFit> fit =
        CircleFit.of(group, settings.rangeSigma()).filter(circle -> isRound(circle, group));
    return Optional.of(fit.isPresent() ? round(fit.get(), height) : around(group, extent, height));
  }

  /** Whether a fit has a plausible size, a small residual, and its centre behind the echoes. */
  private boolean isRound(CircleFit circle, List<Point> group) {
    Point middle = group.get(group.size() / 2);
    return circle.radius() >= settings.minRadius()
        && circle.radius() <= settings.maxRadius()
        && circle.offM() <= TIGHT * settings.rangeSigma()
        && Math.max(circle.sigmaX(), circle.sigmaY()) <= circle.radius()
        && Math.hypot(circle.x(), circle.y()) > Math.hypot(middle.x(), middle.y());
  }

  private static Circle round(CircleFit fit, double height) {
    Circle circle = new Circle().radius(fit.radius());
    circle.x(fit.x()).y(fit.y()).z(height);
    circle.motion().sigma(Point.of(fit.sigmaX(), fit.sigmaY(), 0.0));
    return circle;
  }

  /** Circle around the echoes of an object whose far side is occluded. */
  private Circle around(List<Point> group, double extent, double height) {
    double x = group.stream().mapToDouble(Point::x).average().orElseThrow();
    double y = group.stream().mapToDouble(Point::y).average().orElseThrow();
    double sigma = Math.hypot(settings.rangeSigma(), 0.25 * extent);
    Circle circle = new Circle().radius(Math.max(settings.rangeSigma(), 0.5 * extent));
    circle.x(x).y(y).z(height);
    circle.motion().sigma(Point.of(sigma, sigma, 0.0));
    return circle;
  }

  /**
   * Clusters the echoes of a scan by distance (Rusu, Semantic 3D Object Maps, 2009, Euclidean
   * clustering; along the beams, since a scan is ordered). Beams without an echo between two close
   * echoes do not split a cluster.
   */
  static final class Clusters {
    private static final int BEAMS_PAST = 2; // maximum missing beams within a cluster

    private final ClusterVariables settings;

    Clusters(ClusterVariables settings) {
      this.settings = settings;
    }

    /**
     * Clusters of echoes, as points in BODY in beam order; the last is joined to the first if the
     * scan covers a full circle.
     *
     * @param isGround points to ignore as ground
     */
    List<List<Point>> of(RangeScan scan, Predicate<Point> isGround) {
      Rotation frd = Rotation.nedFromFrd(-scan.phi(), scan.theta(), -scan.psi());
      List<List<Point>> groups = new ArrayList<>();
      List<Point> group = new ArrayList<>();
      int past = 0;
      for (RangeScan.Beam beam : scan.beams()) {
        double range = beam.range().orElse(-1.0);
        if (range < scan.minRange() || range > scan.maxRange()) {
          past++;
          continue;
        }
        Point turned = frd.times(Point.polar(-beam.angle(), 0.0, range));
        Point point = Point.of(scan.x() + turned.x(), scan.y() - turned.y(), scan.z() + turned.z());
        if (isGround.test(point)) {
          past++;
          continue;
        }
        if (!group.isEmpty()
            && (past > BEAMS_PAST || !isNear(group.get(group.size() - 1), point))) {
          groups.add(group);
          group = new ArrayList<>();
        }
        group.add(point);
        past = 0;
      }
      if (!group.isEmpty()) {
        groups.add(group);
      }
      if (groups.size() > 1) {
        List<Point> first = groups.get(0);
        List<Point> last = groups.get(groups.size() - 1);
        if (isNear(last.get(last.size() - 1), first.get(0))) {
          groups.remove(groups.size() - 1);
          first.addAll(0, last);
        }
      }
      return groups;
    }

    private boolean isNear(Point a, Point b) {
      return a.distanceTo(b) <= settings.gap();
    }
  }
}
