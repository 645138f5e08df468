package org.u2sa.planning.local;

/** Area on the planning plane. */
public interface Area {
  /** Whether it contains a position [m]. */
  boolean contains(double northM, double eastM);

  /** Whether a straight way stays in it or, from outside, leads towards it at once [m]. */
  boolean allows(double northM, double eastM, double toNorthM, double toEastM);

  /** Distance from a position to the nearest border [m]; negative outside. */
  double roomM(double northM, double eastM);

  /**
   * Everywhere, or nowhere.
   *
   * @param isEverywhere whether it contains every position
   */
  record Uniform(boolean isEverywhere) implements Area {
    @Override
    public boolean contains(double northM, double eastM) {
      return isEverywhere;
    }

    @Override
    public boolean allows(double northM, double eastM, double toNorthM, double toEastM) {
      return isEverywhere;
    }

    @Override
    public double roomM(double northM, double eastM) {
      return isEverywhere ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
    }
  }
}
