package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * Determines whether a pilot moves the actuators directly, by radio and multiplexer, whatever
 * services command, and watches the radio. While a pilot flies, failsafes are suspended: they would
 * have no effect, and would surprise the pilot when giving back control.
 *
 * <p>The radio's service must confirm it in its health reports, whose names the broker reserves: a
 * mere publisher of manual-state must not suspend failsafes, and a dead radio service cannot report
 * who flies.
 */
final class SafetyPilot implements Watch {
  private static final double MIN_FRESH_S = 1.0;
  private static final double INTERVALS = 4.0; // interval of health reports
  private static final long NEVER = Long.MIN_VALUE;
  private static final String CONFIRMED = "pilot confirmed";
  private static final String LOSS = "pilot's radio lost";
  private static final String HEARD = "pilot's radio heard";

  private final Supplier<SafetyVariables> settings;
  private final Conditions conditions;
  private Optional<ManualState> newest = Optional.empty();
  private boolean isConfirmed; // as of the service's last health report
  private Optional<String> loss = Optional.empty(); // of the radio, likewise
  private long untilMicros = NEVER; // time at which the next health report is due
  private boolean flew; // at the last check

  SafetyPilot(Supplier<SafetyVariables> settings, Conditions conditions) {
    this.settings = settings;
    this.conditions = conditions;
  }

  @Override
  public Hazard hazard() {
    return Hazard.RADIO;
  }

  void see(ManualState state) {
    newest = Optional.of(state);
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (message instanceof HealthReport report
        && report.serviceName().equals(settings.get().pilotService())) {
      boolean isItsOwn = report.threadAlive().isEmpty() && report.status() == ServiceStatus.RUNNING;
      isConfirmed = isItsOwn && remark(report, ManualState.REMARK).isPresent();
      loss =
          remark(report, ManualState.LOSS_REMARK)
              .map(each -> "lost" + each.substring(ManualState.LOSS_REMARK.length()));
      double withinS = Math.max(MIN_FRESH_S, INTERVALS * report.interval().orElse(0.0));
      untilMicros = nowMicros + Clock.micros(withinS);
    }
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    state.flag(CONFIRMED, isConfirmed).flag(HEARD, untilMicros != NEVER);
    loss.ifPresent(words -> state.text(LOSS, words));
  }

  /** What the service last reported counts until its next report is due. */
  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    isConfirmed = state.flag(CONFIRMED);
    loss = state.text(LOSS);
    untilMicros = state.flag(HEARD) ? nowMicros + Clock.micros(MIN_FRESH_S) : NEVER;
  }

  @Override
  public String saved() {
    return "" + isConfirmed + loss.isPresent() + (untilMicros != NEVER);
  }

  private static Optional<String> remark(HealthReport report, String prefix) {
    return report.remarks().stream().filter(each -> each.startsWith(prefix)).findFirst();
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

  /**
   * Whether the pilot flies and the radio is heard, or has just given back control; call it at each
   * check.
   */
  boolean isHeard(long nowMicros) {
    boolean flies = flies(nowMicros);
    boolean givesBack = flew && newest.filter(ManualState::active).isEmpty();
    flew = flies;
    return givesBack || flies && loss.isEmpty();
  }

  /** A radio counts from its first report. */
  @Override
  public Optional<String> trouble(long nowMicros) {
    String service = settings.get().pilotService();
    boolean isSilent = untilMicros != NEVER && nowMicros >= untilMicros;
    return service.isEmpty()
        ? Optional.empty()
        : conditions
            .failure(service)
            .or(() -> isSilent ? Optional.of(service + " sends no reports") : loss);
  }
}
