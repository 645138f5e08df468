package org.u2sa.control.allocation;

import java.util.Locale;

/** The six degrees of freedom, in the order of wrenches: X, Y, Z, K, M, N (SNAME). */
public enum DegreeOfFreedom {
  /** Along the forward axis, X [N]. */
  SURGE,
  /** Along the right axis, Y [N]. */
  SWAY,
  /** Along the down axis, Z [N]. */
  HEAVE,
  /** About the forward axis, K [N m]. */
  ROLL,
  /** About the right axis, M [N m]. */
  PITCH,
  /** About the down axis, N [N m]. */
  YAW;

  /** Number of degrees of freedom. */
  public static final int COUNT = 6;

  /** Human-readable name in lower case. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
