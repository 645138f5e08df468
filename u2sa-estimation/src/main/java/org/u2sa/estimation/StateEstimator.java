package org.u2sa.estimation;

import java.util.HashSet;
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
 * Makes the best estimate of the vehicle's state from what sensors measured (thesis 3.2.3.1). In:
 * sensed-state. Out: state.
 *
 * <p>A subclass writes {@link #estimate}. The estimate's sensorName becomes this service's name, so
 * that receivers tell estimates of two estimators apart; its timestamp is that of the measurement,
 * unless the subclass sets another. Measurements that nothing near the earth can cause are ignored,
 * and so are those of sensors beyond the first 32.
 */
public abstract class StateEstimator extends EventDrivenService {
  private static final double FUTURE_S = 0.5; // clocks of sensors may differ by this much
  private static final int WARN_OF_IGNORED = 100;
  private static final int MAX_SOURCES = 32; // each costs time and memory in every estimate

  private final Set<String> sources = new HashSet<>(); // names of sensors
  private long ignored;
  private long refused;

  /**
   * @param serviceName the name, unless the variable SERVICE NAME says another
   */
  protected StateEstimator(ServiceContext context, String serviceName) {
    super(context, ServiceRole.STATE_ESTIMATOR, serviceName);
    subscribe(Channels.SENSED_STATE, this::onMeasurement);
    registerPublisher(Channels.STATE);
  }

  /**
   * The estimate after one more measurement; empty if it gives no reason to publish one. Called on
   * the service's thread, in the order of arrival.
   *
   * @param sensed frozen; its presence vector says what the sensor measured
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
      estimate(sensed).ifPresent(estimate -> publishEstimate(estimate, sensed));
    } else if (Long.bitCount(++refused) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      trouble(
          String.format(
              "more than %s sensors, \"%s\" is one too many: %s measurements ignored so far",
              MAX_SOURCES, sensed.sensorName(), refused));
    }
  }

  /** Tells people, not each time, of a measurement that does not count. */
  final void ignore(StateInformation sensed, String why) {
    if (ignored++ % WARN_OF_IGNORED == 0) {
      trouble("ignored a measurement of " + sensed.sensorName() + ", which " + why);
    }
  }

  /** Whether a measurement is to be ignored because its time is still to come; people are told. */
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
