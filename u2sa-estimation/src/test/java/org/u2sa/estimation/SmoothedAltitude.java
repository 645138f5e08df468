package org.u2sa.estimation;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/** Smooths the measured altitude. In: sensed-state. Out: state. */
public final class SmoothedAltitude extends StateEstimator {
  private static final VariableDeclaration<Double> SHARE =
      VariableDeclaration.number("SHARE", "")
          .range(Range.of(0.01, 1.0))
          .ifAbsent(0.1)
          .describedAs("Share of a new measurement in the estimate.");

  private OptionalDouble altitudeM = OptionalDouble.empty(); // what was learnt since the start

  /** Called by the launcher. */
  public SmoothedAltitude(ServiceContext context) {
    super(context, "StateEstimator");
    getVariable(SHARE);
  }

  @Override
  protected Optional<StateInformation> estimate(StateInformation sensed) {
    StateInformation estimate = sensed.copy();
    if (sensed.z().isPresent()) {
      double measured = sensed.z().getAsDouble();
      double before = altitudeM.orElse(measured);
      altitudeM = OptionalDouble.of(before + getVariable(SHARE) * (measured - before));
      estimate.z(altitudeM.getAsDouble());
    }
    return Optional.of(estimate);
  }

  @Override
  protected void handOver(HandOver state) {
    altitudeM.ifPresent(metres -> state.number("ALTITUDE", metres));
  }

  @Override
  protected void takeOver(HandOver state) {
    altitudeM = state.number("ALTITUDE"); // empty after an estimator that knows no such value
  }
}
