package org.u2sa.planning.local;

/** Area on the planning plane. */
@FunctionalInterface
public interface Area {
  /** Whether it contains a position [m]. */
  boolean contains(double northM, double eastM);
}
