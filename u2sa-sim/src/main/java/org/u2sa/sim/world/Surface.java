package org.u2sa.sim.world;

import org.u2sa.sim.motion.Arguments;

/** Driving surface: friction and rolling resistance at each point of the local plane. */
public interface Surface {
  /** Coefficient of friction between tyre and ground at a point, above 0. */
  double grip(double eastM, double northM);

  /** Rolling-resistance coefficient at a point, at least 0. */
  double rollingResistance(double eastM, double northM);

  /**
   * Trodden earth and short grass: grip 0.65 (sliding, dry earth road) and rolling resistance 0.05
   * (unpaved road) in Wong, Theory of Ground Vehicles, 3rd ed., tables 1.3 and 1.1.
   */
  static Surface lawn() {
    return even(0.65, 0.05);
  }

  /** Dry concrete: 0.75 and 0.013, from the same tables. */
  static Surface concrete() {
    return even(0.75, 0.013);
  }

  /**
   * A wet, soft field: grip 0.45 (sliding, wet earth road) and rolling resistance 0.1 (lowest value
   * for a field), from the same tables.
   */
  static Surface field() {
    return even(0.45, 0.1);
  }

  /**
   * A uniform surface.
   *
   * @throws IllegalArgumentException if a coefficient is outside its range
   */
  static Surface even(double grip, double rollingResistance) {
    Arguments.requireInside("grip", grip, 0.01, 2.0);
    Arguments.requireInside("rolling resistance", rollingResistance, 0.0, 0.5);
    return new Surface() {
      @Override
      public double grip(double eastM, double northM) {
        return grip;
      }

      @Override
      public double rollingResistance(double eastM, double northM) {
        return rollingResistance;
      }
    };
  }
}
