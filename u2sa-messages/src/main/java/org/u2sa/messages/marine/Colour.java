package org.u2sa.messages.marine;

/** Painted colour of an object. Names are part of the wire format; append only. */
public enum Colour {
  RED,
  ORANGE,
  YELLOW,
  GREEN,
  BLUE,
  WHITE,
  BLACK,
  PURPLE
}
