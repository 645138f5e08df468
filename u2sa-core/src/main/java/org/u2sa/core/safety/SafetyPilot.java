package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ManualState;

/**
 * Whether a pilot moves the actuators himself, by a radio and a multiplexer, whatever services
 * command. As long as he does, failsafes cannot help, and would surprise him when he gives back.
 *
 * <p>His radio's service must confirm it in its health reports, whose names the broker keeps for
 * their services: whoever may publish a manual-state must not suspend failsafes, and a radio whose
 * service has died no longer says who flies.
 */
final class SafetyPilot {
  private static final double MIN_FRESH_S = 1.0;
  private static final double INTERVALS = 4.0; // of health reports

  private final Supplier<SafetyVariables> settings;
  private final Conditions conditions;
  private Optional<ManualState> newest = Optional.empty();
  private boolean isConfirmed; // by the service's last health report
  private long untilMicros = Long.MIN_VALUE; // time at which another health report is due

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

  /** Whether he flies, as far as a service knows that works. */
  boolean flies(long nowMicros) {
    String service = settings.get().pilotService();
    return !service.isEmpty()
        && newest.filter(ManualState::active).isPresent()
        && isConfirmed
        && nowMicros < untilMicros
        && conditions.failure(service).isEmpty();
  }
}
