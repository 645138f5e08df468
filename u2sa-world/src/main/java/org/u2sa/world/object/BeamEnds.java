package org.u2sa.world.object;

import java.util.List;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.grid.BeamDirections;
import org.u2sa.world.grid.ScanEntry;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.SensorPose;

/** End points of a scan's beams in the map: at an obstacle or in free space. */
final class BeamEnds {
  private final BeamDirections directions = new BeamDirections();
  private double[] x = {}; // along the map's axes [m]
  private double[] y = {};
  private double[] z = {};
  private double[] free = {}; // free length [m]
  private boolean[] echoes = {};
  private int count;

  /**
   * Computes the end points of a scan.
   *
   * @param up +1 if the map's z axis points up, else -1
   */
  void take(RangeScan scan, ScanPoses poses, ScanEntry.Band band, double up) {
    List<Double> ranges = scan.ranges();
    List<Boolean> returns = scan.returns();
    count = scan.beamCount();
    if (count > x.length) {
      x = new double[count];
      y = new double[count];
      z = new double[count];
      free = new double[count];
      echoes = new boolean[count];
    }
    directions.of(scan, count);
    int parts = poses.moved() ? Math.max(1, Math.min(ScanEntry.PARTS, count)) : 1;
    for (int part = 0; part < parts; part++) {
      int from = count * part / parts;
      int to = count * (part + 1) / parts;
      SensorPose pose = poses.at(scan, (from + to) / 2.0 / Math.max(1, count));
      for (int i = from; i < to; i++) {
        boolean echo = returns.get(i) && ranges.get(i) <= scan.maxRange();
        end(i, pose, echo ? ranges.get(i) : Math.min(scan.maxRange(), band.freeRange()));
        double height = up * (z[i] - pose.vehicle().z());
        boolean isObstacle = height >= band.lowest() && height <= band.highest();
        echoes[i] = echo && ranges.get(i) >= scan.minRange() && isObstacle;
        free[i] = echo && !echoes[i] && isObstacle ? 0.0 : free[i]; // self-return
      }
    }
    for (int i = 1; i + 1 < count; i++) { // a single echo lost on a smooth or dark surface
      boolean isLost = !returns.get(i) && echoes[i - 1] && echoes[i + 1];
      free[i] = isLost ? Math.min(free[i - 1], free[i + 1]) : free[i];
    }
  }

  private void end(int beam, SensorPose pose, double range) {
    double ahead = range * directions.cos(beam);
    double aside = range * directions.sin(beam);
    Point place = pose.place();
    x[beam] = place.x() + ahead * pose.ahead().x() + aside * pose.aside().x();
    y[beam] = place.y() + ahead * pose.ahead().y() + aside * pose.aside().y();
    z[beam] = place.z() + ahead * pose.ahead().z() + aside * pose.aside().z();
    free[beam] = range;
  }

  int count() {
    return count;
  }

  boolean isEcho(int beam) {
    return echoes[beam];
  }

  double x(int beam) {
    return x[beam];
  }

  double y(int beam) {
    return y[beam];
  }

  double z(int beam) {
    return z[beam];
  }

  /** Free length of a beam [m]; 0 if unknown. */
  double freeM(int beam) {
    return free[beam];
  }

  /** Horizontal distance between two ends [m]. */
  double apartM(int one, int two) {
    return Math.hypot(x[one] - x[two], y[one] - y[two]);
  }
}
