package org.u2sa.gcs.export;

import java.util.HashMap;
import java.util.Map;

/** Leaves out what comes too soon after what was last taken of the same kind. */
final class Spacing {
  private final double everyS;
  private final Map<Object, Double> takenS = new HashMap<>();

  /**
   * @param everyS least time between two that are taken [s]; 0: all are
   */
  Spacing(double everyS) {
    this.everyS = everyS;
  }

  /** Whether one of that kind is to be taken at that time [s]. */
  boolean takes(Object kind, double timeS) {
    Double last = takenS.get(kind);
    if (last != null && timeS < last + everyS) {
      return false;
    }
    takenS.put(kind, timeS);
    return true;
  }
}
