package org.u2sa.messages.contract;

/**
 * What a vehicle does because something is wrong, the mildest first. The names travel; append only.
 */
public enum FailsafeAction {
  /** Goes on with its mission. */
  CONTINUE,
  /** Stays where it is: stands, hovers or circles. */
  HOLD,
  /** Goes home. */
  RETURN,
  /** Comes down where it is safe to. */
  LAND,
  /** Everything that moves goes neutral at once. */
  STOP
}
