package org.u2sa.messages;

/** How much an object is to be avoided (thesis 3.2.3.5). The names travel; append only. */
public enum ObjectLevel {
  /** At all costs. */
  AVOID_ALWAYS,
  /** If there is another way. */
  AVOID_IF_POSSIBLE,
  /** Passable, at a price. */
  HINDRANCE
}
