package org.u2sa.sim.world;

import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * A ramp of boards on level ground: rises, may have a flat top, and descends, with a constant
 * profile across its width and vertical sides. Rays see sharp edges; wheels see edges smoothed over
 * {@link #WHEELBASE_M}.
 *
 * <p>Convex, so a ray enters it at most once, at the last entered plane.
 */
public final class Ramp {
  /** Wheelbase over which {@link #rise} is averaged [m]. */
  public static final double WHEELBASE_M = 0.4;

  private static final double STRAIGHT_M = 0.02; // maximum lateral deviation of points
  private static final double GROUND_M = 1e-3; // maximum height of the feet above ground

  private static final double BESIDE_M = 1e-3; // exceeds rounding errors

  private final double eastM; // position of the first foot
  private final double northM;
  private final double cos; // cosine of its direction, anticlockwise from east
  private final double sin;
  private final double halfM;
  private final double[] along; // position of each edge, from the first foot [m]
  private final double[] up;
  private final double highestM;
  private final double[] area; // profile area from the first foot to each edge [m²]

  /**
   * @param profile profile along its centre line: east, north, up [m]; both feet on the ground
   * @param widthM width [m]
   * @throws IllegalArgumentException if it is not straight in plan view, not convex, or has no
   *     width
   */
  public Ramp(List<Point> profile, double widthM) {
    if (profile.size() < 3 || !(widthM > 0.0)) {
      throw new IllegalArgumentException(
          "ramp of " + profile.size() + " points, " + widthM + " m wide: expected three points");
    }
    Point foot = profile.get(0);
    Point end = profile.get(profile.size() - 1);
    double length = Math.hypot(end.x() - foot.x(), end.y() - foot.y());
    eastM = foot.x();
    northM = foot.y();
    cos = (end.x() - eastM) / length;
    sin = (end.y() - northM) / length;
    halfM = 0.5 * widthM;
    along = new double[profile.size()];
    up = new double[profile.size()];
    area = new double[profile.size()];
    for (int i = 0; i < along.length; i++) {
      Point at = profile.get(i);
      along[i] = along(at.x(), at.y());
      up[i] = at.z();
      require(Math.abs(left(at.x(), at.y())) <= STRAIGHT_M, "is not straight", at);
      boolean isFoot = i == 0 || i == along.length - 1;
      require(!isFoot || Math.abs(up[i]) <= GROUND_M, "has a foot above the ground", at);
      if (i > 0) {
        require(along[i] > along[i - 1], "goes back", at);
        area[i] = area[i - 1] + 0.5 * (up[i] + up[i - 1]) * (along[i] - along[i - 1]);
      }
      require(i < 2 || slope(i - 1) <= slope(i - 2), "is not convex", at);
    }
    highestM = Arrays.stream(up).max().orElse(0.0);
  }

  private static void require(boolean isSo, String fault, Point at) {
    if (!isSo) {
      throw new IllegalArgumentException("ramp " + fault + " at " + at);
    }
  }

  private double slope(int part) {
    return (up[part + 1] - up[part]) / (along[part + 1] - along[part]);
  }

  /** Distance along the ramp from its first foot [m]. */
  public double along(double placeEastM, double placeNorthM) {
    return (placeEastM - eastM) * cos + (placeNorthM - northM) * sin;
  }

  /** Distance left of the centre line [m]. */
  public double left(double placeEastM, double placeNorthM) {
    return (placeNorthM - northM) * cos - (placeEastM - eastM) * sin;
  }

  /** Length from foot to foot [m]. */
  public double lengthM() {
    return along[along.length - 1];
  }

  /** Width [m]. */
  public double widthM() {
    return 2.0 * halfM;
  }

  /** Height of its top [m]. */
  public double highestM() {
    return highestM;
  }

  /** Maximum slope magnitude [1]. */
  public double steepest() {
    return Math.max(slope(0), -slope(along.length - 2));
  }

  /** Whether a point is on the ramp. */
  public boolean carries(double placeEastM, double placeNorthM) {
    double on = along(placeEastM, placeNorthM);
    return on >= 0.0 && on <= lengthM() && Math.abs(left(placeEastM, placeNorthM)) <= halfM;
  }

  /** Height of the wheel centre line at a point [m]; 0 off the ramp. */
  double heightM(double placeEastM, double placeNorthM) {
    if (Math.abs(left(placeEastM, placeNorthM)) > halfM) {
      return 0.0;
    }
    double on = along(placeEastM, placeNorthM);
    return (below(on + 0.5 * WHEELBASE_M) - below(on - 0.5 * WHEELBASE_M)) / WHEELBASE_M;
  }

  /** Slope along the ramp between front and rear wheels [1]. */
  double rise(double placeEastM, double placeNorthM) {
    if (Math.abs(left(placeEastM, placeNorthM)) > halfM) {
      return 0.0;
    }
    double on = along(placeEastM, placeNorthM);
    return (sharp(on + 0.5 * WHEELBASE_M) - sharp(on - 0.5 * WHEELBASE_M)) / WHEELBASE_M;
  }

  double riseEast(double placeEastM, double placeNorthM) {
    return rise(placeEastM, placeNorthM) * cos;
  }

  double riseNorth(double placeEastM, double placeNorthM) {
    return rise(placeEastM, placeNorthM) * sin;
  }

  private double sharp(double on) {
    int part = part(on);
    return part < 0 ? 0.0 : up[part] + slope(part) * (on - along[part]);
  }

  /** Profile area up to a position [m²]. */
  private double below(double on) {
    int part = part(on);
    if (part < 0) {
      return on < 0.0 ? 0.0 : area[area.length - 1];
    }
    return area[part] + 0.5 * (up[part] + sharp(on)) * (on - along[part]);
  }

  /** Index of the profile segment at a position; −1 if none. */
  private int part(double on) {
    if (on <= 0.0 || on >= lengthM()) {
      return -1;
    }
    int part = 0;
    while (on > along[part + 1]) {
      part++;
    }
    return part;
  }

  /** Whether a ray from above passes beside the ramp on its way to the ground. */
  private boolean passes(double s, double a, double z, double ds, double da, double dz) {
    if (dz >= 0.0) {
      return true;
    }
    double top = (highestM - z) / dz;
    double ground = -z / dz;
    double s0 = s + top * ds;
    double s1 = s + ground * ds;
    double a0 = a + top * da;
    double a1 = a + ground * da;
    return Math.max(s0, s1) < -BESIDE_M
        || Math.min(s0, s1) > lengthM() + BESIDE_M
        || Math.max(a0, a1) < -halfM - BESIDE_M
        || Math.min(a0, a1) > halfM + BESIDE_M;
  }

  /**
   * Intersection with a ray.
   *
   * @param normal receives the surface normal: east, north, up; may be null
   * @return distance in lengths of the direction; 0 if the ray starts inside, infinite for a miss
   */
  public double meets(
      double x, double y, double z, double dx, double dy, double dz, double[] normal) {
    double s = along(x, y);
    double a = left(x, y);
    double ds = dx * cos + dy * sin;
    double da = dy * cos - dx * sin;
    if (z > highestM && passes(s, a, z, ds, da, dz)) {
      return Double.POSITIVE_INFINITY;
    }
    double enter = 0.0;
    double leave = Double.POSITIVE_INFINITY;
    int face = -1;
    for (int i = 0; i <= along.length; i++) {
      boolean isSide = i >= along.length - 1;
      double sign = i == along.length ? -1.0 : 1.0;
      double slope = isSide ? 0.0 : slope(i);
      double outside = isSide ? sign * a - halfM : z - up[i] - slope * (s - along[i]);
      double rate = isSide ? sign * da : dz - slope * ds;
      if (rate == 0.0) {
        leave = outside > 0.0 ? -1.0 : leave;
      } else if (rate > 0.0) {
        leave = Math.min(leave, -outside / rate);
      } else if (-outside / rate > enter) {
        enter = -outside / rate;
        face = i;
      }
    }
    if (enter > leave || z + enter * dz < 0.0) {
      return Double.POSITIVE_INFINITY;
    }
    if (normal != null) {
      normal(face, normal);
    }
    return enter;
  }

  private void normal(int face, double[] into) {
    if (face < 0 || face >= along.length - 1) {
      double sign = face == along.length ? -1.0 : 1.0;
      into[0] = -sign * sin;
      into[1] = sign * cos;
      into[2] = 0.0;
      return;
    }
    double slope = slope(face);
    double by = 1.0 / Math.sqrt(1.0 + slope * slope);
    into[0] = -slope * cos * by;
    into[1] = -slope * sin * by;
    into[2] = by;
  }

  /** Point on the surface at a distance along and to the left: east, north, height [m]. */
  public Point at(double alongM, double leftM) {
    return Point.of(
        eastM + alongM * cos - leftM * sin, northM + alongM * sin + leftM * cos, sharp(alongM));
  }
}
