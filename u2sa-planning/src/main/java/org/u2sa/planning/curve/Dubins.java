package org.u2sa.planning.curve;

import java.util.ArrayList;
import java.util.List;

/**
 * Shortest path of a forward-only vehicle with a minimum turn radius (Dubins: On Curves of Minimal
 * Length with a Constraint on Average Curvature, American Journal of Mathematics 79, 1957; formulas
 * after Shkel and Lumelsky: Classification of the Dubins Set, Robotics and Autonomous Systems 34,
 * 2001).
 */
public final class Dubins {
  private static final double TURN = 2.0 * Math.PI;
  private static final double ROUNDING = 1.0e-6;
  private static final int[] LSL = {-1, 0, -1};
  private static final int[] RSR = {1, 0, 1};
  private static final int[] LSR = {-1, 0, 1};
  private static final int[] RSL = {1, 0, -1};
  private static final int[] RLR = {1, -1, 1};
  private static final int[] LRL = {-1, 1, -1};

  private Dubins() {}

  public static Curve shortest(Pose from, Pose to, double radiusM) {
    Best best = new Best();
    offer(from, to, radiusM, best);
    return Curve.of(radiusM, best.lengths, best.word);
  }

  /** All paths of a turn, a straight or a turn, and a turn; up to six. */
  public static List<Curve> all(Pose from, Pose to, double radiusM) {
    List<Curve> all = new ArrayList<>();
    offer(
        from,
        to,
        radiusM,
        (word, t, p, q) -> all.add(Curve.of(radiusM, new double[] {t, p, q}, word)));
    return all;
  }

  private static void offer(Pose from, Pose to, double radiusM, Offers best) {
    Pose rel = from.relative(to);
    double dx = rel.northM() / radiusM;
    double dy = -rel.eastM() / radiusM; // the paper's y is to the left, angles counter-clockwise
    double d = Math.hypot(dx, dy);
    double theta = d > 0.0 ? Math.atan2(dy, dx) : 0.0;
    double alpha = mod(-theta);
    double beta = mod(-rel.headingRad() - theta);
    double sa = Math.sin(alpha);
    double sb = Math.sin(beta);
    double ca = Math.cos(alpha);
    double cb = Math.cos(beta);
    double cab = Math.cos(alpha - beta);
    double lsl = 2.0 + d * d - 2.0 * cab + 2.0 * d * (sa - sb); // eq. 1
    if (lsl >= -ROUNDING) {
      double towards = lsl < ROUNDING * ROUNDING ? alpha : Math.atan2(cb - ca, d + sa - sb);
      best.offer(LSL, mod(towards - alpha), Math.sqrt(Math.max(0.0, lsl)), mod(beta - towards));
    }
    double rsr = 2.0 + d * d - 2.0 * cab + 2.0 * d * (sb - sa); // eq. 2
    if (rsr >= -ROUNDING) {
      double towards = rsr < ROUNDING * ROUNDING ? alpha : Math.atan2(ca - cb, d - sa + sb);
      best.offer(RSR, mod(alpha - towards), Math.sqrt(Math.max(0.0, rsr)), mod(towards - beta));
    }
    double lsr = -2.0 + d * d + 2.0 * cab + 2.0 * d * (sa + sb); // eq. 3
    if (lsr >= -ROUNDING) {
      double p = Math.sqrt(Math.max(0.0, lsr));
      double towards = Math.atan2(-ca - cb, d + sa + sb) - Math.atan2(-2.0, p);
      best.offer(LSR, mod(towards - alpha), p, mod(towards - beta));
    }
    double rsl = -2.0 + d * d + 2.0 * cab - 2.0 * d * (sa + sb); // eq. 4
    if (rsl >= -ROUNDING) {
      double p = Math.sqrt(Math.max(0.0, rsl));
      double towards = Math.atan2(ca + cb, d - sa - sb) - Math.atan2(2.0, p);
      best.offer(RSL, mod(alpha - towards), p, mod(beta - towards));
    }
    double rlr = (6.0 - d * d + 2.0 * cab + 2.0 * d * (sa - sb)) / 8.0; // eq. 5
    if (Math.abs(rlr) <= 1.0) {
      double p = mod(TURN - Math.acos(rlr));
      double t = mod(alpha - Math.atan2(ca - cb, d - sa + sb) + p / 2.0);
      best.offer(RLR, t, p, mod(alpha - beta - t + p));
    }
    double lrl = (6.0 - d * d + 2.0 * cab + 2.0 * d * (sb - sa)) / 8.0; // eq. 6
    if (Math.abs(lrl) <= 1.0) {
      double p = mod(TURN - Math.acos(lrl));
      double t = mod(-alpha + Math.atan2(cb - ca, d + sa - sb) + p / 2.0);
      best.offer(LRL, t, p, mod(beta - alpha - t + p));
    }
  }

  /** Adds a word with the lengths of its pieces in radii. */
  private interface Offers {
    void offer(int[] word, double t, double p, double q);
  }

  /** The shortest of some words. */
  private static final class Best implements Offers {
    private double length = Double.POSITIVE_INFINITY;
    private double[] lengths;
    private int[] word;

    @Override
    public void offer(int[] offered, double t, double p, double q) {
      if (t + p + q < length) {
        length = t + p + q;
        lengths = new double[] {t, p, q};
        word = offered;
      }
    }
  }

  /**
   * Shortest path to a point with any final heading: a turn and a straight, or two turns if the
   * point lies inside a turning circle (Bui, Boissonnat, Soueres, Laumond: Shortest Path Synthesis
   * for Dubins Non-holonomic Robot, ICRA 1994).
   */
  public static Curve shortest(Pose from, double northM, double eastM, double radiusM) {
    Pose rel = from.relative(new Pose(northM, eastM, 0.0));
    double x = rel.northM() / radiusM;
    int side = rel.eastM() >= 0.0 ? 1 : -1;
    double y = side * rel.eastM() / radiusM; // mirrored, so that the point is on the right
    if (Math.hypot(x, y - 1.0) >= 1.0) {
      return Curve.of(radiusM, turnThenStraight(x, y), new int[] {side, 0});
    }
    double[] away = turnThenStraight(x, -y); // the long way round, via the other side
    double length = away[0] + away[1];
    double[] best = null;
    // Turn left until the right circle there passes through the point: the centres of both
    // circles and the point form a triangle with sides 2, 1 and far.
    double far = Math.hypot(x, y + 1.0);
    double angle = Math.acos(Math.max(-1.0, Math.min(1.0, (far * far + 3.0) / (4.0 * far))));
    for (int sign = -1; sign <= 1; sign += 2) {
      double first = mod(Math.atan2(x, y + 1.0) + sign * angle);
      double centreX = 2.0 * Math.sin(first);
      double centreY = 2.0 * Math.cos(first) - 1.0;
      double second = mod(Math.atan2(x - centreX, centreY - y) + first);
      if (first + second < length) {
        length = first + second;
        best = new double[] {first, second};
      }
    }
    return best == null
        ? Curve.of(radiusM, away, new int[] {-side, 0})
        : Curve.of(radiusM, best, new int[] {-side, side});
  }

  /** Path to a point on the right, outside the circle: right turn [rad] and straight. */
  private static double[] turnThenStraight(double x, double y) {
    // The circle's centre is at (0, 1); seen from the point, the angle between tangent point and
    // centre is asin(1 / distance).
    double away = Math.hypot(x, y - 1.0);
    double heading = Math.atan2(y - 1.0, x) + Math.asin(Math.min(1.0, 1.0 / away));
    return new double[] {mod(heading), Math.sqrt(Math.max(0.0, away * away - 1.0))};
  }

  private static double mod(double rad) {
    double turned = rad % TURN;
    if (turned < 0.0) {
      turned += TURN;
    }
    return turned > TURN - ROUNDING ? 0.0 : turned; // a full turn counts as no turn
  }
}
