package org.u2sa.core.safety;

import java.util.Optional;

/** Whether the state estimator works: by the health monitor's word, and by the states that come. */
final class EstimatorWatch implements Watch {
  private final PositionWatch states;
  private final Watch service;

  EstimatorWatch(PositionWatch states, Watch service) {
    this.states = states;
    this.service = service;
  }

  @Override
  public Hazard hazard() {
    return Hazard.ESTIMATOR;
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    Optional<String> failure = service.trouble(nowMicros);
    return failure.isEmpty() && states.fresh(nowMicros).isEmpty()
        ? Optional.of("no fresh states")
        : failure;
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return Optional.empty(); // the position's says it
  }
}
