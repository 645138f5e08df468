package org.u2sa.planning.avoidance;

import org.u2sa.planning.avoidance.Avoidance.Wanted;
import org.u2sa.planning.local.ArcChoice;

/** Last choice of a vehicle that cannot stop; valid for a few metres of flight. */
record HeldChoice(ArcChoice choice, Wanted wanted, long micros) {
  private static final long LASTS_MICROS = 100_000;

  boolean isFor(Wanted now, long nowMicros) {
    return now.goal().equals(wanted.goal())
        && now.target().equals(wanted.target())
        && nowMicros - micros < LASTS_MICROS;
  }
}
