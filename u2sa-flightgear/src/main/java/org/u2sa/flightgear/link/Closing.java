package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;

/** Closes what is given up anyway; should that fail, it is said and life goes on. */
final class Closing {
  private Closing() {}

  static void quietly(Closeable thing, Troubles troubles) {
    try {
      thing.close();
    } catch (IOException e) {
      troubles.event("closing a connection failed: " + e.getMessage());
    }
  }
}
