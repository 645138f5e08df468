package org.u2sa.world.object;

import java.util.List;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.modeller.SensorPose;

/** Determines whether a scan passed through an object's position, which rules it out. */
final class ScanThrough {
  private static final double THICKNESS_M = 0.3; // of the slice that a scan covers
  private static final double MARGIN_M = 0.2;

  private final RangeScan scan;
  private final SensorPose pose;
  private final List<Double> ranges;
  private final List<Boolean> returns;

  ScanThrough(RangeScan scan, SensorPose pose) {
    this.scan = scan;
    this.pose = pose;
    ranges = scan.ranges();
    returns = scan.returns();
  }

  /**
   * Whether all beams toward a position passed beyond it.
   *
   * @param place position in map coordinates [m]
   * @param radius radius of the object, including its position uncertainty [m]
   */
  boolean passed(Point place, double radius) {
    Point way = place.minus(pose.place());
    double ahead = way.dot(pose.ahead());
    double aside = way.dot(pose.aside());
    double distance = Math.hypot(ahead, aside);
    double off = Math.sqrt(Math.max(0.0, square(way.distance()) - square(distance)));
    double behind = distance + radius + MARGIN_M;
    boolean inView =
        off <= THICKNESS_M + radius && behind < scan.maxRange() && distance > scan.minRange();
    if (!inView || scan.angleIncrement() == 0.0 || !scan.angles().isEmpty()) {
      return false;
    }
    double half = Math.asin(Math.min(1.0, radius / distance));
    double middle = beam(Math.atan2(aside, ahead));
    double wide = half / Math.abs(scan.angleIncrement());
    int from = (int) Math.floor(middle - wide);
    int to = (int) Math.ceil(middle + wide);
    int beams = Math.min(ranges.size(), returns.size());
    if (from < 0 || to >= beams) {
      return false;
    }
    for (int i = from; i <= to; i++) {
      if (returns.get(i) && ranges.get(i) <= behind) {
        return false;
      }
    }
    return true;
  }

  private double beam(double angle) {
    double turn = Math.abs(2.0 * Math.PI / scan.angleIncrement());
    double beam = (angle - scan.startAngle()) / scan.angleIncrement();
    return beam - turn * Math.floor(beam / turn);
  }

  private static double square(double value) {
    return value * value;
  }
}
