package org.u2sa.estimation;

import java.util.HashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Base class of services that estimate the vehicle's state from sensor measurements (thesis
 * 3.2.3.1). In: sensed-state. Out: state.
 *
 * <p>A subclass implements {@link #estimate}. The estimate's sensorName is set to this service's
 * name, so that receivers can distinguish estimators; its timestamp defaults to that of the
 * measurement. Implausible measurements are ignored, as are sensors beyond the first 32.
 */
public abstract class StateEstimator extends EventDrivenService {
  private static final double FUTURE_S = 0.5; // tolerated clock difference between sensors
  private static final double NOTEWORTHY_S = 0.05; // of that
  private static final int WARN_OF_IGNORED = 100;
  private static final int MAX_SOURCES = 32; // each costs time and memory in every estimate

  private final Set<String> sources = new HashSet<>(); // names of sensors
  private final Set<String> ahead = new HashSet<>(); // those whose clock is noticeably ahead
  private long ignored;
  private long refused;

  /**
   * @param serviceName default name; the variable SERVICE NAME overrides it
   */
  protected StateEstimator(ServiceContext context, String serviceName) {
    super(context, ServiceRole.STATE_ESTIMATOR, serviceName);
    subscribe(Channels.SENSED_STATE, this::onMeasurement);
    registerPublisher(Channels.STATE);
  }

  /**
   * Updates the estimate with a measurement; empty if there is nothing to publish. Called on the
   * service's thread, in order of arrival.
   *
   * @param sensed frozen; its presence vector marks the measured fields
   * @return a new message, not frozen
   */
  protected abstract Optional<StateInformation> estimate(StateInformation sensed);

  private void onMeasurement(StateInformation sensed) {
    if (sensed.timestamp().isEmpty()) {
      log(LogLevelEnum.WARN, "ignored a measurement without a timestamp: " + sensed);
      return;
    }
    Optional<String> objection = Plausibility.objection(sensed);
    if (objection.isPresent()) {
      ignore(sensed, "says " + objection.get());
      return;
    }
    if (sources.contains(sensed.sensorName())
        || sources.size() < MAX_SOURCES && sources.add(sensed.sensorName())) {
      StateInformation timely = onArrival(sensed);
      estimate(timely).ifPresent(estimate -> publishEstimate(estimate, timely));
    } else if (Long.bitCount(++refused) == 1) { // exponential back-off of the log
      trouble(
          String.format(
              "more than %s sensors: ignored %3$s measurements so far, last of \"%2$s\"",
              MAX_SOURCES, sensed.sensorName(), refused));
    }
  }

  /**
   * A measurement of a clock that is a little ahead counts as made on arrival: nothing is measured
   * after its message arrives, and an estimate must not run ahead of this service's time.
   */
  private StateInformation onArrival(StateInformation sensed) {
    long now = clock().micros();
    double aheadS = Clock.seconds(sensed.timestamp().orElseThrow() - now);
    if (aheadS <= 0.0 || aheadS > FUTURE_S) {
      return sensed;
    }
    if (aheadS > NOTEWORTHY_S && ahead.add(sensed.sensorName())) {
      trouble(
          String.format(
              Locale.ROOT,
              "the clock of %s is %.2f s ahead: its measurements count as made on arrival",
              sensed.sensorName(),
              aheadS));
    }
    StateInformation timely = sensed.copy();
    timely.timestamp(now);
    timely.freeze();
    return timely;
  }

  /** Reports an ignored measurement, rate-limited. */
  final void ignore(StateInformation sensed, String why) {
    if (ignored++ % WARN_OF_IGNORED == 0) {
      trouble("ignored a measurement of " + sensed.sensorName() + ", which " + why);
    }
  }

  /** Whether a measurement must be ignored because it is from the future; reports it if so. */
  final boolean isFromTheFuture(StateInformation sensed) {
    double aheadS = Clock.seconds(sensed.timestamp().orElseThrow() - clock().micros());
    if (aheadS <= FUTURE_S) {
      return false;
    }
    ignore(sensed, "is from the future");
    return true;
  }

  private void publishEstimate(StateInformation estimate, StateInformation sensed) {
    estimate.sensorName(getServiceName());
    if (estimate.timestamp().isEmpty()) {
      estimate.timestamp(sensed.timestamp().orElseThrow());
    }
    publish(Channels.STATE, estimate);
  }
}
