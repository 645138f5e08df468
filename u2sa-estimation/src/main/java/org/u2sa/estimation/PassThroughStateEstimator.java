package org.u2sa.estimation;

import java.util.Optional;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Uses the measurements as the state (thesis 4.5.2.2, 4.6.2.2): copies each present field of a
 * measurement, including those added by a message subclass, to a new message. In: sensed-state.
 * Out: state, at the time of the newest measurement.
 *
 * <p>With several sensors, such as a GPS and a compass (thesis 4.6.3), fields that one does not
 * measure are filled in from the newest measurement of another in the same frame: position and
 * attitude are extrapolated to the state's time by the rates measured with them, their standard
 * deviations grow with age, and measurements older than STALE AFTER are discarded. There is no
 * fusion: if two sensors measure the same quantity, the newest measurement wins.
 */
public final class PassThroughStateEstimator extends StateEstimator {
  private record Limits(
      @Variable(unit = "m/s", min = 0, ifAbsent = 0.1)
          @Description(
              "Standard deviation assumed for a measured velocity without one; position uncertainty grows with it over time.")
          double velocitySigma,
      @Variable(unit = "m/s^2", min = 0, ifAbsent = 1)
          @Description(
              "Unmeasured acceleration, 1 sigma: position uncertainty grows by ½ a t² with age t.")
          double acceleration,
      @Variable(unit = "m/s", min = 0, ifAbsent = 1) @Description("Speed, 1 sigma, if unmeasured.")
          double unknownSpeed,
      @Variable(unit = "rad/s", min = 0, ifAbsent = 0.5)
          @Description("Assumed turn rate, 1 sigma, where none is measured.")
          double unknownTurnRate,
      @Variable(unit = "s", min = 0.01, max = 60, ifAbsent = 2)
          @Description("Maximum age of one sensor's measurement for combination with another's.")
          double staleAfter) {}

  private final NewestMeasurements measurements;
  private final Completeness completeness;

  public PassThroughStateEstimator(ServiceContext context) {
    super(context, "StateEstimator");
    Limits limits = settings(Limits.class).get(); // changes take effect at the next start
    DeadReckoning reckoning =
        new DeadReckoning(
            limits.velocitySigma(),
            limits.acceleration(),
            limits.unknownSpeed(),
            limits.unknownTurnRate());
    measurements = new NewestMeasurements(Clock.micros(limits.staleAfter()), reckoning);
    completeness = NeededNumbers.watch(this);
  }

  @Override
  protected Optional<StateInformation> estimate(StateInformation sensed) {
    if (sensed instanceof LandmarkSighting) {
      return Optional.empty(); // needs a filter
    }
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
