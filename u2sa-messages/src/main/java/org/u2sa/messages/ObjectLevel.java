package org.u2sa.messages;

/**
 * Strictness of avoiding an object (thesis 3.2.3.5). Names are part of the wire format; append
 * only.
 */
public enum ObjectLevel {
  /** At all costs. */
  AVOID_ALWAYS,
  /** Avoid if there is another way. */
  AVOID_IF_POSSIBLE,
  /** Passable, at a price. */
  HINDRANCE
}
