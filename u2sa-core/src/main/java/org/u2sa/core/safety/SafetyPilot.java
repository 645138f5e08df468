package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ManualState;

/**
 * Determines whether a pilot moves the actuators directly, by radio and multiplexer, whatever
 * services command. Failsafes are then suspended: they would have no effect, and would surprise the
 * pilot when giving back control.
 *
 * <p>The radio's service must confirm it in its health reports, whose names the broker reserves: a
 * mere publisher of manual-state must not suspend failsafes, and a dead radio service cannot report
 * who flies.
 */
final class SafetyPilot {
  private static final double MIN_FRESH_S = 1.0;
  private static final double INTERVALS = 4.0; // interval of health reports

  private final Supplier<SafetyVariables> settings;
  private final Conditions conditions;
  private Optional<ManualState> newest = Optional.empty();
  private boolean isConfirmed; // as of the service's last health report
  private long untilMicros = Long.MIN_VALUE; // time at which the next health report is due

  SafetyPilot(Supplier<SafetyVariables> settings, Conditions conditions) {
    this.settings = settings;
    this.conditions = conditions;
  }

  void see(ManualState state) {
    newest = Optional.of(state);
  }

  void see(HealthReport report, long nowMicros) {
    boolean isItsOwn = report.threadAlive().isEmpty() && report.status() == ServiceStatus.RUNNING;
    if (report.serviceName().equals(settings.get().pilotService())) {
      isConfirmed =
          isItsOwn
              && report.remarks().stream().anyMatch(each -> each.startsWith(ManualState.REMARK));
      double withinS = Math.max(MIN_FRESH_S, INTERVALS * report.interval().orElse(0.0));
      untilMicros = nowMicros + Clock.micros(withinS);
    }
  }

  /** Whether the pilot flies, according to a working service. */
  boolean flies(long nowMicros) {
    String service = settings.get().pilotService();
    return !service.isEmpty()
        && newest.filter(ManualState::active).isPresent()
        && isConfirmed
        && nowMicros < untilMicros
        && conditions.failure(service).isEmpty();
  }
}
