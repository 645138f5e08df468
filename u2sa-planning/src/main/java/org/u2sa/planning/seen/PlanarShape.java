package org.u2sa.planning.seen;

import java.util.Arrays;
import java.util.Optional;

/**
 * Static obstacle on the planning plane: everything within a radius of points, of a chain of lines,
 * or of an area. Immutable.
 */
public final class PlanarShape {
  private static final double TOUCHES_M = 1.0e-3;

  public enum Kind {
    /** Isolated points. */
    POINTS,
    /** Points joined in order. */
    CHAIN,
    /** Points joined in order to a closed ring, including its interior. */
    AREA
  }

  private final String name;
  private final Kind kind;
  private final double[] norths;
  private final double[] easts;
  private final double radiusM;
  private final double topDownM;
  private final double bottomDownM;
  private final boolean isBall;

  /**
   * @param name UID of the object
   * @param norths north coordinates of the points [m], at least one
   * @param easts east coordinates of the points [m], same number
   * @param radiusM radius around points and lines [m]
   * @param topDownM down coordinate of its top [m]; −∞ if unbounded
   * @param bottomDownM down coordinate of its bottom [m]; ∞ if unbounded
   */
  public PlanarShape(
      String name,
      Kind kind,
      double[] norths,
      double[] easts,
      double radiusM,
      double topDownM,
      double bottomDownM) {
    this(name, kind, norths, easts, radiusM, topDownM, bottomDownM, false);
  }

  private PlanarShape(
      String name,
      Kind kind,
      double[] norths,
      double[] easts,
      double radiusM,
      double topDownM,
      double bottomDownM,
      boolean isBall) {
    this.name = name;
    this.kind = kind;
    this.norths = norths.clone();
    this.easts = easts.clone();
    this.radiusM = radiusM;
    this.topDownM = topDownM;
    this.bottomDownM = bottomDownM;
    this.isBall = isBall;
  }

  /** Creates a vertically unbounded disc. */
  public static PlanarShape disc(String name, double northM, double eastM, double radiusM) {
    return new PlanarShape(
        name,
        Kind.POINTS,
        new double[] {northM},
        new double[] {eastM},
        radiusM,
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY);
  }

  /** Creates a vertically unbounded chain without width. */
  public static PlanarShape wall(String name, double[] norths, double[] easts) {
    return new PlanarShape(
        name, Kind.CHAIN, norths, easts, 0.0, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
  }

  public String name() {
    return name;
  }

  public Kind kind() {
    return kind;
  }

  public int count() {
    return norths.length;
  }

  /** North of a point [m]. */
  public double northM(int point) {
    return norths[point];
  }

  /** East of a point [m]. */
  public double eastM(int point) {
    return easts[point];
  }

  /** Radius around points and lines [m]. */
  public double radiusM() {
    return radiusM;
  }

  /** Down coordinate of its top [m]; −∞ if unbounded. */
  public double topDownM() {
    return topDownM;
  }

  /** Down coordinate of its bottom [m]; ∞ if unbounded. */
  public double bottomDownM() {
    return bottomDownM;
  }

  /** Copy of the outline and heights of a sphere, marked as one if it has an extent. */
  PlanarShape asBall() {
    return new PlanarShape(
        name, kind, norths, easts, radiusM, topDownM, bottomDownM, radiusM > 0.0);
  }

  /** Whether it is a sphere, not a shape with vertical sides. */
  public boolean isBall() {
    return isBall;
  }

  /** Its height [m]; 0 if it is unbounded. */
  double heightM() {
    return Double.isFinite(bottomDownM) ? bottomDownM - topDownM : 0.0;
  }

  /** Whether it overlaps the height band between two down coordinates [m], with a margin. */
  public boolean reaches(double oneDownM, double otherDownM, double marginM) {
    return topDownM - marginM <= Math.max(oneDownM, otherDownM)
        && bottomDownM + marginM >= Math.min(oneDownM, otherDownM);
  }

  /** Whether another shape covers the same points, regardless of name and heights. */
  boolean isOfSameOutline(PlanarShape other) {
    return kind == other.kind
        && radiusM == other.radiusM
        && Arrays.equals(norths, other.norths)
        && Arrays.equals(easts, other.easts);
  }

  /** Distance of a point from it [m]; 0 inside. */
  public double distanceM(double north, double east) {
    if (kind == Kind.AREA && isInside(north, east)) {
      return 0.0;
    }
    double least = Double.POSITIVE_INFINITY;
    int last = norths.length - 1;
    for (int i = 0; i <= last; i++) {
      int next = i < last ? i + 1 : 0;
      boolean joined = kind == Kind.AREA || (kind == Kind.CHAIN && i < last);
      double away =
          joined
              ? segmentM(north, east, norths[i], easts[i], norths[next], easts[next])
              : Math.hypot(north - norths[i], east - easts[i]);
      least = Math.min(least, away);
    }
    return Math.max(0.0, least - radiusM);
  }

  /** Part of a shape of one point that is at least this far from a position [m]; empty if none. */
  Optional<PlanarShape> apartFrom(double north, double east, double awayM) {
    double mostM = Math.hypot(north - norths[0], east - easts[0]) - awayM;
    if (mostM >= radiusM) {
      return Optional.of(this);
    }
    return mostM <= 0.0
        ? Optional.empty()
        : Optional.of(new PlanarShape(name, kind, norths, easts, mostM, topDownM, bottomDownM));
  }

  /** Whether a point is inside the ring (even-odd rule). */
  public boolean isInside(double north, double east) {
    boolean inside = false;
    for (int i = 0, j = norths.length - 1; i < norths.length; j = i++) {
      if (easts[i] > east != easts[j] > east
          && north
              < norths[i] + (norths[j] - norths[i]) * (east - easts[i]) / (easts[j] - easts[i])) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** Whether a straight way crosses its outline, or touches one of its corners. */
  public boolean isCrossedBy(double north, double east, double toNorth, double toEast) {
    for (int i = 0, j = norths.length - 1; i < norths.length; j = i++) {
      if (cross(north, east, toNorth, toEast, norths[j], easts[j], norths[i], easts[i])
          || segmentM(norths[i], easts[i], north, east, toNorth, toEast) < TOUCHES_M) {
        return true;
      }
    }
    return false;
  }

  /** Whether two segments cross; not if one only touches the other. */
  public static boolean cross(
      double n1, double e1, double n2, double e2, double n3, double e3, double n4, double e4) {
    return side(n1, e1, n2, e2, n3, e3) * side(n1, e1, n2, e2, n4, e4) < 0.0
        && side(n3, e3, n4, e4, n1, e1) * side(n3, e3, n4, e4, n2, e2) < 0.0;
  }

  private static double side(double n1, double e1, double n2, double e2, double n, double e) {
    return (n2 - n1) * (e - e1) - (e2 - e1) * (n - n1);
  }

  /** Distance of a point from a line segment [m]. */
  public static double segmentM(
      double north, double east, double n1, double e1, double n2, double e2) {
    double along = (n2 - n1) * (n2 - n1) + (e2 - e1) * (e2 - e1);
    double share =
        along == 0.0
            ? 0.0
            : Math.max(
                0.0, Math.min(1.0, ((north - n1) * (n2 - n1) + (east - e1) * (e2 - e1)) / along));
    double n = north - n1 - share * (n2 - n1);
    double e = east - e1 - share * (e2 - e1);
    return Math.sqrt(n * n + e * e); // hypot is ten times slower
  }

  /** Bounds: minimum and maximum north, minimum and maximum east [m]. */
  double[] bounds() {
    double[] bounds = {norths[0], norths[0], easts[0], easts[0]};
    for (int i = 1; i < norths.length; i++) {
      bounds[0] = Math.min(bounds[0], norths[i]);
      bounds[1] = Math.max(bounds[1], norths[i]);
      bounds[2] = Math.min(bounds[2], easts[i]);
      bounds[3] = Math.max(bounds[3], easts[i]);
    }
    bounds[0] -= radiusM;
    bounds[1] += radiusM;
    bounds[2] -= radiusM;
    bounds[3] += radiusM;
    return bounds;
  }
}
