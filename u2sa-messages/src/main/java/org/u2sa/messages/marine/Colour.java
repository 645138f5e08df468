package org.u2sa.messages.marine;

/** Painted colour of an object. Names are part of the wire format; append only. */
public enum Colour {
  /** Red. */
  RED,
  /** Orange. */
  ORANGE,
  /** Yellow. */
  YELLOW,
  /** Green. */
  GREEN,
  /** Blue. */
  BLUE,
  /** White. */
  WHITE,
  /** Black. */
  BLACK,
  /** Purple. */
  PURPLE
}
