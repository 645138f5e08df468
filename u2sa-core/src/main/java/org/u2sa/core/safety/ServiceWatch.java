package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;

/** Whether services without which a vehicle is lame still work, by the health monitor's word. */
final class ServiceWatch implements Watch {
  private final Hazard hazard;
  private final Conditions conditions;
  private final Supplier<String> services;

  /**
   * @param services names with commas between
   */
  ServiceWatch(Hazard hazard, Conditions conditions, Supplier<String> services) {
    this.hazard = hazard;
    this.conditions = conditions;
    this.services = services;
    services.get(); // declared before the first message comes
  }

  @Override
  public Hazard hazard() {
    return hazard;
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    for (String service : Words.names(services.get())) {
      Optional<String> failure = conditions.failure(service);
      if (failure.isPresent()) {
        return failure;
      }
    }
    return Optional.empty();
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return Optional.empty(); // all that are not alive are listed
  }
}
