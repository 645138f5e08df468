package org.u2sa.scenarios.igvc;

import java.util.Random;

/** Fraction of courses with a ramp, if there is room. */
enum Ramps {
  /** None. */
  NONE,
  /** Half of them. */
  SOME,
  /** All. */
  ALL;

  private static final double SHARE = 0.5;

  /** Whether a course gets a ramp. Always draws one random number. */
  boolean isDue(Random random) {
    boolean isOneOfSome = random.nextDouble() < SHARE;
    return this == ALL || this == SOME && isOneOfSome;
  }
}
