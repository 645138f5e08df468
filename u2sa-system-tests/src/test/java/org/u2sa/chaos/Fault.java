package org.u2sa.chaos;

import java.util.List;
import java.util.Random;

/**
 * What is broken when, drawn from a seed: two runs with one seed break the same things in the same
 * order.
 *
 * @param number 1 for the first of a run
 * @param kind how
 * @param draw which of the possible victims, as a number to be taken modulo their count
 * @param durationS how long, if it lasts [s]
 * @param pauseS how long after all is well the next one comes [s]
 * @param seed of what is random within the fault
 */
record Fault(int number, Kind kind, int draw, double durationS, double pauseS, long seed) {
  /** The ways to break something. */
  enum Kind {
    /** kill −9 of a service's process. */
    KILL(true),
    /** A service's process stands still with all its threads. */
    FREEZE(true),
    /** A service's thread does not return; the rest of its process lives. */
    HANG(true),
    /** kill −9 of the broker, and a new one after a while. */
    BROKER_RESTART(false),
    /** One service's connection is reset. */
    CUT_ONE(false),
    /** All connections are reset, and new ones refused for a while. */
    CUT_ALL(false),
    /** One service's connection carries nothing for a while, and no end sees an error. */
    STALL_ONE(false),
    /** All connections carry nothing for a while. */
    STALL_ALL(false),
    /** Random bytes in the middle of a service's packets. */
    GARBAGE_IN_STREAM(false),
    /** Random bytes instead of packets at the broker's port. */
    GARBAGE_AT_BROKER(false),
    /** Random bytes as messages on the vehicle's own topics. */
    GARBAGE_MESSAGES(false),
    /** Ten times the vehicle's own traffic, well formed and for nobody. */
    FLOOD(false),
    /** The connections to the aircraft are reset. */
    AIRCRAFT_CUT(false),
    /** Random bytes on the aircraft's ports. */
    AIRCRAFT_GARBAGE(false);

    private final boolean endsService;

    Kind(boolean endsService) {
      this.endsService = endsService;
    }

    /** Whether a service is gone for good, so that somebody must notice and start it again. */
    boolean endsService() {
      return endsService;
    }
  }

  private static final double SHORTEST_S = 0.5;
  private static final double LONGEST_S = 4.0;
  private static final double LONGEST_PAUSE_S = 2.0;

  /** The next fault, of one of the kinds. */
  static Fault draw(int number, List<Kind> kinds, Random random) {
    return new Fault(
        number,
        kinds.get(random.nextInt(kinds.size())),
        random.nextInt(Integer.MAX_VALUE),
        SHORTEST_S + random.nextDouble() * (LONGEST_S - SHORTEST_S),
        random.nextDouble() * LONGEST_PAUSE_S,
        random.nextLong());
  }
}
