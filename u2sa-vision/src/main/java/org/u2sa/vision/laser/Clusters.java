package org.u2sa.vision.laser;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Clusters the echoes of a scan by distance (Rusu, Semantic 3D Object Maps, 2009, Euclidean
 * clustering; along the beams, since a scan is ordered). Beams without an echo between two close
 * echoes do not split a cluster.
 */
final class Clusters {
  private static final int BEAMS_PAST = 2; // missing beams within a cluster

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
      if (!group.isEmpty() && (past > BEAMS_PAST || !isNear(group.get(group.size() - 1), point))) {
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
