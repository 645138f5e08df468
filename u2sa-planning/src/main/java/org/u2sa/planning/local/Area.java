package org.u2sa.planning.local;

/** Area on the planning plane. */
public interface Area {
  /** Whether it contains a position [m]. */
  boolean contains(double northM, double eastM);

  /** Whether a straight way stays in it or, from outside, leads towards it at once [m]. */
  boolean allows(double northM, double eastM, double toNorthM, double toEastM);

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
  }
}
