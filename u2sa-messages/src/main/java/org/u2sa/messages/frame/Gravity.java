package org.u2sa.messages.frame;

/** The acceleration of free fall. */
public final class Gravity {
  /** Standard acceleration of gravity [m/s²] (ISO 80000-3). */
  public static final double STANDARD_MPS2 = 9.80665;

  private Gravity() {}
}
