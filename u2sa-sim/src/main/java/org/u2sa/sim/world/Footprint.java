package org.u2sa.sim.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Collision shape of a vehicle: an upright prism over a convex outline that rotates with heading
 * but ignores roll and pitch.
 */
public final class Footprint {
  private static final double ROUNDING = 1e-6; // exceeds the rounding error of a rotated corner [m]

  private final double[] ahead; // corners, in order
  private final double[] right;
  private final double bottomM;
  private final double topM;
  private final double reachM; // horizontal distance of the farthest corner

  /**
   * @param corners outline corners in order, x ahead and y right of the reference point [m]
   * @param bottomM height of the bottom above the reference point, negative below [m]
   * @param topM height of the top above the reference point [m]
   * @throws IllegalArgumentException if the outline is not convex, or the top below the bottom
   */
  public Footprint(List<Point> corners, double bottomM, double topM) {
    ahead = corners.stream().mapToDouble(Point::x).toArray();
    right = corners.stream().mapToDouble(Point::y).toArray();
    this.bottomM = bottomM;
    this.topM = topM;
    double farthest = 0.0;
    for (int i = 0; i < ahead.length; i++) {
      farthest = Math.max(farthest, Math.hypot(ahead[i], right[i]));
    }
    reachM = farthest;
    int turns = 0;
    for (int i = 0; i < ahead.length; i++) {
      int j = (i + 1) % ahead.length;
      int k = (i + 2) % ahead.length;
      double cross =
          (ahead[j] - ahead[i]) * (right[k] - right[j])
              - (right[j] - right[i]) * (ahead[k] - ahead[j]);
      turns += (int) Math.signum(cross);
    }
    if (ahead.length < 3 || Math.abs(turns) != ahead.length || !(topM >= bottomM)) {
      throw new IllegalArgumentException(
          "footprint "
              + corners
              + " from "
              + bottomM
              + " m to "
              + topM
              + " m: expected the corners of a convex outline in order, and a top above the bottom");
    }
  }

  /**
   * A rectangular footprint that starts at the ground under the reference point.
   *
   * @param aheadM extent ahead of the reference point [m]
   * @param behindM extent behind the reference point [m]
   */
  public static Footprint rectangle(
      double aheadM, double behindM, double widthM, double bottomM, double topM) {
    double half = widthM / 2.0;
    return new Footprint(
        List.of(
            Point.of(aheadM, -half, 0.0),
            Point.of(aheadM, half, 0.0),
            Point.of(-behindM, half, 0.0),
            Point.of(-behindM, -half, 0.0)),
        bottomM,
        topM);
  }

  /** Corners of the outline in order, x ahead and y right of the reference point [m]. */
  public List<Point> corners() {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < ahead.length; i++) {
      corners.add(Point.of(ahead[i], right[i], 0.0));
    }
    return corners;
  }

  /** Height of the bottom above the reference point [m], negative below. */
  public double bottomM() {
    return bottomM;
  }

  /** Height of the top above the reference point [m]. */
  public double topM() {
    return topM;
  }

  /** Extent along the vehicle's forward axis [m]. */
  public double lengthM() {
    return extent(ahead);
  }

  /** Extent along the vehicle's right axis [m]. */
  public double widthM() {
    return extent(right);
  }

  private static double extent(double[] values) {
    return Arrays.stream(values).max().orElseThrow() - Arrays.stream(values).min().orElseThrow();
  }

  /** Bounding box of a vehicle at a position [east, north, up], for any heading. */
  Bounds around(Point place) {
    double reach = reachM + ROUNDING;
    return new Bounds(
        place.x() - reach,
        place.y() - reach,
        place.z() + bottomM,
        place.x() + reach,
        place.y() + reach,
        place.z() + topM);
  }

  /**
   * The prism in world coordinates, for a vehicle at a position [east, north, up] with a heading
   * [rad].
   */
  Prism at(Point place, double headingRad) {
    double sin = StrictMath.sin(headingRad);
    double cos = StrictMath.cos(headingRad);
    double[] east = new double[ahead.length];
    double[] north = new double[ahead.length];
    for (int i = 0; i < ahead.length; i++) {
      east[i] = place.x() + ahead[i] * sin + right[i] * cos;
      north[i] = place.y() + ahead[i] * cos - right[i] * sin;
    }
    return new Prism(east, north, place.z() + bottomM, place.z() + topM);
  }
}
