package org.u2sa.core.safety;

import java.util.Optional;

/** Whether the health monitor has given a service up, by its policy or after its restarts. */
final class GivenUpWatch implements Watch {
  private final Conditions conditions;

  GivenUpWatch(Conditions conditions) {
    this.conditions = conditions;
  }

  @Override
  public Hazard hazard() {
    return Hazard.SERVICE;
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    return conditions.givenUp();
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return Optional.empty(); // all that are not alive are listed
  }
}
