package org.u2sa.chaos;

import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.time.Clock;

/** Waits for what is to become true, within limits. */
record Patience(Clock clock) {
  private static final double LOOK_EVERY_S = 0.1;

  /** Returns whether it became true in time. */
  boolean await(double withinS, BooleanSupplier truth) throws InterruptedException {
    long deadline = clock.micros() + Clock.micros(withinS);
    try (Clock.Waiter waiter = clock.newWaiter("chaos-patience")) {
      while (!truth.getAsBoolean()) {
        if (clock.micros() > deadline) {
          return false;
        }
        waiter.await(clock.micros() + Clock.micros(LOOK_EVERY_S));
      }
    }
    return true;
  }
}
