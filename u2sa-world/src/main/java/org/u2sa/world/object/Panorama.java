package org.u2sa.world.object;

import java.util.Arrays;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.modeller.SensorPose;

/** Free range around a scanner as seen by one scan, by direction in the map. Immutable. */
final class Panorama {
  private static final int SECTORS = 720;
  private static final double RAD_TO_SECTORS = SECTORS / (2.0 * Math.PI);
  private static final double MAX_GAP_RAD = Math.toRadians(4.0); // between adjacent beams
  private static final double THICKNESS_M = 0.3; // of the slice that a scan covers

  private final long micros;
  private final Point from;
  private final double slopeX; // slope of the scan plane
  private final double slopeY;
  private final float[] free = new float[SECTORS]; // free range [m]; 0 without a beam

  Panorama(BeamEnds ends, SensorPose pose, long micros) {
    this.micros = micros;
    from = pose.place();
    Point a = pose.ahead();
    Point b = pose.aside();
    double up = a.x() * b.y() - a.y() * b.x(); // component of the plane's normal
    slopeX = up == 0.0 ? 0.0 : -(a.y() * b.z() - a.z() * b.y()) / up;
    slopeY = up == 0.0 ? 0.0 : -(a.z() * b.x() - a.x() * b.z()) / up;
    Arrays.fill(free, Float.POSITIVE_INFINITY);
    for (int i = 1; i < ends.count(); i++) {
      fill(ends, i - 1, i);
    }
    if (ends.count() > 0) {
      fill(ends, ends.count() - 1, 0); // closes a full-circle scan
    }
    for (int i = 0; i < SECTORS; i++) {
      free[i] = Float.isInfinite(free[i]) ? 0.0f : free[i];
    }
  }

  /** Marks the space between two beams as free up to the nearer end. */
  private void fill(BeamEnds ends, int one, int two) {
    double start = Math.atan2(ends.y(one) - from.y(), ends.x(one) - from.x());
    double end = Math.atan2(ends.y(two) - from.y(), ends.x(two) - from.x());
    double gap = Math.IEEEremainder(end - start, 2.0 * Math.PI);
    if (Math.abs(gap) <= MAX_GAP_RAD) {
      float both = (float) Math.min(ends.freeM(one), ends.freeM(two));
      int first = (int) Math.floor(Math.min(start, start + gap) * RAD_TO_SECTORS);
      int last = (int) Math.floor(Math.max(start, start + gap) * RAD_TO_SECTORS);
      for (int i = first; i <= last; i++) {
        int sector = Math.floorMod(i, SECTORS);
        free[sector] = Math.min(free[sector], both);
      }
    }
  }

  /** Time of the scan [µs]. */
  long micros() {
    return micros;
  }

  /**
   * Whether a position and its surroundings were free.
   *
   * @param marginM radius around it [m]
   */
  boolean isFree(double x, double y, double z, double marginM) {
    double dx = x - from.x();
    double dy = y - from.y();
    double away = Math.hypot(dx, dy);
    double middle = Math.atan2(dy, dx) * RAD_TO_SECTORS;
    double behind = away + marginM;
    if (away <= marginM
        || free[Math.floorMod((int) Math.floor(middle), SECTORS)] < behind
        || Math.abs(z - from.z() - dx * slopeX - dy * slopeY) > THICKNESS_M) {
      return false;
    }
    double half = Math.asin(marginM / away) * RAD_TO_SECTORS;
    int last = (int) Math.floor(middle + half);
    for (int i = (int) Math.floor(middle - half); i <= last; i++) {
      if (free[Math.floorMod(i, SECTORS)] < behind) {
        return false;
      }
    }
    return true;
  }
}
