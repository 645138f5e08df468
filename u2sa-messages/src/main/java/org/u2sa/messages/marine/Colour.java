package org.u2sa.messages.marine;

/** Colours of buoys and other marks. Names are part of the wire format; append only. */
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
