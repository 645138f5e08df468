package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;

/** Makes the watches of all hazards: the standard ones, then the extensions'. */
final class Watches {
  private Watches() {}

  static List<Watch> of(
      Configurator matrix,
      Supplier<SafetySettings> settings,
      Conditions conditions,
      FenceFile fence) {
    PositionWatch position = new PositionWatch(settings);
    List<Watch> all = new ArrayList<>();
    Collections.addAll(
        all,
        HeartbeatWatch.ofOperators(settings),
        position,
        new ServiceWatch(
            Hazard.ESTIMATOR,
            now -> {
              Optional<String> failure = conditions.failure(settings.get().estimatorService());
              return failure.isEmpty() && position.fresh(now).isEmpty()
                  ? Optional.of("no fresh states")
                  : failure;
            }),
        new ServiceWatch(
            Hazard.ACTUATOR_LINK, now -> conditions.failure(settings.get().actuatorServices())),
        new ActuationWatch(settings),
        HeartbeatWatch.ofMonitor(settings),
        new ServiceWatch(Hazard.SERVICE, now -> conditions.givenUp()),
        BatteryWatch.low(settings),
        BatteryWatch.critical(settings),
        new FenceWatch(matrix, settings, fence, position));
    all.addAll(ExtensionWatch.discovered(matrix));
    return all;
  }

  /**
   * Whether essential services work. Never objects to arming: {@link ArmingChecks} lists all
   * services that are not alive.
   *
   * @param failure what is wrong at a time of the run's clock [µs], in words; empty if nothing
   */
  private record ServiceWatch(Hazard hazard, LongFunction<Optional<String>> failure)
      implements Watch {
    @Override
    public Optional<String> trouble(long nowMicros) {
      return failure.apply(nowMicros);
    }

    @Override
    public Optional<String> objection(long nowMicros) {
      return Optional.empty();
    }
  }
}
