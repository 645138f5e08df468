package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.LongFunction;

/**
 * Whether essential services work. Never objects to arming: {@link ArmingChecks} lists all services
 * that are not alive.
 *
 * @param failure what is wrong at a time of the run's clock [µs], in words; empty if nothing
 */
record ServiceWatch(Hazard hazard, LongFunction<Optional<String>> failure) implements Watch {
  @Override
  public Optional<String> trouble(long nowMicros) {
    return failure.apply(nowMicros);
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return Optional.empty();
  }
}
