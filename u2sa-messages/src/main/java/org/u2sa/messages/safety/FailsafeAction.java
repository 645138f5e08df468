package org.u2sa.messages.safety;

/**
 * Reaction of a vehicle to a fault, mildest first. Names are part of the wire format; append only.
 */
public enum FailsafeAction {
  /** Continues its mission. */
  CONTINUE,
  /** Holds its position: stops, hovers or circles. */
  HOLD,
  /** Returns home. */
  RETURN,
  /** Lands where it is safe. */
  LAND,
  /** Everything that moves goes neutral immediately. */
  STOP
}
