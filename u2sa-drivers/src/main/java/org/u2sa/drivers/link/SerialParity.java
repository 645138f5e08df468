package org.u2sa.drivers.link;

import java.util.Locale;

/** The parity bit of a serial line. */
enum SerialParity {
  NONE,
  EVEN,
  ODD;

  static SerialParity of(LinkAddress address) {
    String text = address.option("parity");
    if (text.isEmpty()) {
      return NONE;
    }
    for (SerialParity parity : values()) {
      if (parity.name().toLowerCase(Locale.ROOT).equals(text)) {
        return parity;
      }
    }
    throw address.refused("option \"parity\": \"" + text + "\" is not none, even or odd");
  }
}
