package org.u2sa.core.estimation;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/**
 * Takes what sensors measured for the state (thesis 4.5.2.2, 4.6.2.2): each field that a
 * measurement's presence vector names is copied to a new message, each field that a subclass of the
 * message adds too. In: sensed-state. Out: state, at the time of the newest measurement.
 *
 * <p>With several sensors, such as a GPS and a compass (thesis 4.6.3), what one does not measure is
 * taken from the newest measurement of another in the same frame: position and attitude are carried
 * ahead to the state's time by the rates measured with them, their standard deviations grow with
 * age, and what is older than STALE AFTER drops out. It does not fuse: of two that measure the
 * same, the newest counts.
 */
public final class PassThroughStateEstimator extends StateEstimator {
  static final VariableDeclaration<Double> STALE_AFTER =
      VariableDeclaration.number("STALE AFTER", "s")
          .range(Range.of(0.01, 60.0))
          .ifAbsent(2.0)
          .describedAs(
              "Age at which what one sensor measured no longer completes what another measures.");

  static final VariableDeclaration<Double> VELOCITY_SIGMA =
      VariableDeclaration.number("VELOCITY SIGMA", "m/s")
          .range(Range.nonNegative())
          .ifAbsent(0.1)
          .describedAs(
              "Standard deviation of a measured velocity that comes without one: by it a position grows unsure with age.");

  static final VariableDeclaration<Double> ACCELERATION =
      VariableDeclaration.number("ACCELERATION", "m/s^2")
          .range(Range.nonNegative())
          .ifAbsent(1.0)
          .describedAs(
              "Acceleration that may have gone unmeasured, 1 sigma: by its half times the age's square a position grows unsure.");

  static final VariableDeclaration<Double> UNKNOWN_SPEED =
      VariableDeclaration.number("UNKNOWN SPEED", "m/s")
          .range(Range.nonNegative())
          .ifAbsent(1.0)
          .describedAs("Speed, 1 sigma, that is counted with where none is measured.");

  static final VariableDeclaration<Double> UNKNOWN_TURN =
      VariableDeclaration.number("UNKNOWN TURN RATE", "rad/s")
          .range(Range.nonNegative())
          .ifAbsent(0.5)
          .describedAs("Turn rate, 1 sigma, that is counted with where none is measured.");

  static final VariableDeclaration<String> NEEDED =
      VariableDeclaration.text("NEEDED")
          .ifAbsent("x, y, psi")
          .describedAs(
              "Numbers that the vehicle cannot do without: health says which are absent for long.");

  static final VariableDeclaration<Double> COMPLETE_WITHIN =
      VariableDeclaration.number("COMPLETE WITHIN", "s")
          .range(Range.positive())
          .ifAbsent(5.0)
          .describedAs("How long a needed number may be absent before health says so.");

  private final NewestMeasurements measurements;
  private final Completeness completeness;

  /** Called by the launcher. */
  public PassThroughStateEstimator(ServiceContext context) {
    super(context, "StateEstimator");
    DeadReckoning reckoning =
        new DeadReckoning(
            getVariable(VELOCITY_SIGMA),
            getVariable(ACCELERATION),
            getVariable(UNKNOWN_SPEED),
            getVariable(UNKNOWN_TURN));
    measurements = new NewestMeasurements(Clock.micros(getVariable(STALE_AFTER)), reckoning);
    completeness =
        new Completeness(
            this, needed(getVariable(NEEDED)), Clock.micros(getVariable(COMPLETE_WITHIN)));
  }

  private static List<StateField> needed(String names) {
    try {
      return Completeness.fields(names);
    } catch (IllegalArgumentException e) {
      throw new BadInputException("variable \"NEEDED\": " + e.getMessage(), e);
    }
  }

  @Override
  protected Optional<StateInformation> estimate(StateInformation sensed) {
    Optional<StateInformation> state = measurements.with(sensed);
    state.ifPresent(each -> completeness.look(each, measurements.all()));
    return state;
  }

  @Override
  protected void handOver(HandOver state) {
    state.messages("MEASUREMENTS", measurements.all());
  }

  @Override
  protected void takeOver(HandOver state) {
    measurements.takeOver(state.messages("MEASUREMENTS", StateInformation.class));
  }
}
