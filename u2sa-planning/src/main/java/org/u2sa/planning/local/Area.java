package org.u2sa.planning.local;

/** Area on the planning plane. */
public interface Area {
  /** Whether it contains a position [m]. */
  boolean contains(double northM, double eastM);

  /** Whether a straight way stays in it or, from outside, leads towards it at once [m]. */
  boolean allows(double northM, double eastM, double toNorthM, double toEastM);
}
