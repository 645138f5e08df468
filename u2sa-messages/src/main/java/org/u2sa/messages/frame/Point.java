package org.u2sa.messages.frame;

/**
 * A point in space, in axes given by the context (thesis 3.2.3.6, figure 10).
 *
 * <p>Stored as Cartesian coordinates; {@link #azimuth()}, {@link #elevation()} and {@link
 * #distance()} are the thesis's polar view of the same point. In {@link ReferenceFrame#GLOBAL} x is
 * longitude [deg], y is latitude [deg] and z altitude [m]; polar values have no meaning there.
 *
 * @param x along the x axis [m]; longitude [deg] in GLOBAL
 * @param y along the y axis [m]; latitude [deg] in GLOBAL
 * @param z along the z axis [m]; altitude above mean sea level in GLOBAL
 */
public record Point(double x, double y, double z) {
  /** The origin of the axes. */
  public static final Point ORIGIN = new Point(0.0, 0.0, 0.0);

  /**
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  public Point {
    requireFinite("x", x);
    requireFinite("y", y);
    requireFinite("z", z);
  }

  /**
   * Creates a point from coordinates [m].
   *
   * @throws IllegalArgumentException if one is NaN or infinite
   */
  public static Point of(double x, double y, double z) {
    return new Point(x, y, z);
  }

  /**
   * Creates a point from direction and distance, as measured by range finders.
   *
   * @param azimuth angle from +x towards +y [rad]
   * @param elevation angle from the x-y plane towards +z [rad]; in BODY, whose z points down,
   *     positive is below the horizon
   * @param distance from the origin [m], not negative
   */
  public static Point polar(double azimuth, double elevation, double distance) {
    if (distance < 0.0) {
      throw new IllegalArgumentException("distance: " + distance + " m is negative");
    }
    double flat = distance * Math.cos(elevation);
    return of(flat * Math.cos(azimuth), flat * Math.sin(azimuth), distance * Math.sin(elevation));
  }

  private static void requireFinite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(
          "Point " + name + ": " + value + " is not a finite number");
    }
  }

  /** Angle from +x towards +y [rad, -π…π]; 0 at the origin. */
  public double azimuth() {
    return Math.atan2(y, x);
  }

  /** Angle from the x-y plane towards +z [rad, -π/2…π/2]; 0 at the origin. */
  public double elevation() {
    return Math.atan2(z, Math.hypot(x, y));
  }

  /** Distance from the origin [m]. */
  public double distance() {
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** Straight distance to another point of the same Cartesian axes [m]. */
  public double distanceTo(Point other) {
    return minus(other).distance();
  }

  /** The vector from {@code other} to this point. */
  public Point minus(Point other) {
    return of(x - other.x, y - other.y, z - other.z);
  }

  /** Vector sum. */
  public Point plus(Point other) {
    return of(x + other.x, y + other.y, z + other.z);
  }

  /** This vector multiplied by a factor. */
  public Point times(double factor) {
    return of(factor * x, factor * y, factor * z);
  }

  /** Scalar product. */
  public double dot(Point other) {
    return x * other.x + y * other.y + z * other.z;
  }

  /** Vector product. */
  public Point cross(Point other) {
    return of(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  /** The same vector with axes north, east, down instead of east, north, up, or vice versa. */
  public Point axesExchanged() {
    return of(y, x, -z);
  }

  /** Distance in the x-y plane to another point of the same Cartesian axes [m]. */
  public double flatDistanceTo(Point other) {
    return Math.hypot(x - other.x, y - other.y);
  }

  /** Distance in the x-y plane to the segment from {@code a} to {@code b} [m]. */
  public double flatDistanceTo(Point a, Point b) {
    double dx = b.x - a.x;
    double dy = b.y - a.y;
    double square = dx * dx + dy * dy;
    double share =
        square == 0.0
            ? 0.0
            : Math.max(0.0, Math.min(1.0, ((x - a.x) * dx + (y - a.y) * dy) / square));
    return Math.hypot(x - a.x - share * dx, y - a.y - share * dy);
  }

  /** "(x, y, z)". */
  @Override
  public String toString() {
    return "(" + x + ", " + y + ", " + z + ")";
  }
}
