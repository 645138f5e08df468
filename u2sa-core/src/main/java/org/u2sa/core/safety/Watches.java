package org.u2sa.core.safety;

import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Creates the standard watches, except that of the fence. */
final class Watches {
  private Watches() {}

  static List<Watch> standard(
      Supplier<SafetyVariables> settings,
      Conditions conditions,
      NamedServices named,
      PositionWatch position) {
    return Stream.of(
            HeartbeatWatch.ofOperators(settings),
            HeartbeatWatch.ofLongLostOperators(settings),
            position,
            new ServiceWatch(
                Hazard.ESTIMATOR,
                now -> {
                  Optional<String> failure = conditions.failure(settings.get().estimatorService());
                  return failure.isEmpty() && position.fresh(now).isEmpty()
                      ? Optional.of("no fresh states")
                      : failure;
                },
                named::unknownEstimator),
            new ServiceWatch(
                Hazard.ACTUATOR_LINK,
                now -> conditions.failure(settings.get().actuatorServices()),
                named::unknownActuatorService),
            new ActuationWatch(settings),
            HeartbeatWatch.ofMonitor(settings),
            new ServiceWatch(Hazard.SERVICE, now -> conditions.givenUp(), Optional::empty),
            BatteryWatch.low(settings),
            BatteryWatch.critical(settings),
            new BatterySilenceWatch(settings))
        .map(GuardedWatch::new)
        .collect(Collectors.toList());
  }

  /**
   * Watch of essential services. Objects to arming only if one is unknown, because {@link
   * ArmingChecks} lists all services that are not alive.
   *
   * @param failure failure at a time of the run's clock [µs], in words; empty if none
   * @param unknown a named service that has not reported, in words; empty if none
   */
  private record ServiceWatch(
      Hazard hazard, LongFunction<Optional<String>> failure, Supplier<Optional<String>> unknown)
      implements Watch {
    @Override
    public Optional<String> trouble(long nowMicros) {
      return failure.apply(nowMicros);
    }

    @Override
    public Optional<String> objection(long nowMicros) {
      return unknown.get();
    }
  }
}
