package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/** Checks that a periodic sender still sends. */
final class HeartbeatWatch implements Watch {
  /** Expectation: sender, whether required before the first message, and timeout [s]. */
  private record Expected(String who, boolean required, double deadlineS) {}

  private final Hazard hazard;
  private final Supplier<Expected> expected;
  private final BiFunction<U2SAData, Expected, Optional<String>> sender;
  private final boolean ofOperators;
  private final Silence silence;
  private String heard = ""; // who sent last

  private HeartbeatWatch(
      Hazard hazard,
      Supplier<Expected> expected,
      BiFunction<U2SAData, Expected, Optional<String>> sender,
      boolean ofOperators) {
    this.ofOperators = ofOperators;
    this.hazard = hazard;
    silence = new Silence(hazard.words());
    this.expected = expected;
    this.sender = sender;
  }

  /** Watches the link to the operators; any operator keeps it alive. */
  static HeartbeatWatch ofOperators(Supplier<SafetyVariables> settings) {
    return ofOperators(
        Hazard.OPERATOR,
        () ->
            new Expected(
                "operator", settings.get().operatorRequired(), settings.get().operatorDeadline()));
  }

  /** Watches for a longer loss of the link, which has its own action. */
  static HeartbeatWatch ofLongLostOperators(Supplier<SafetyVariables> settings) {
    return ofOperators(
        Hazard.OPERATOR_FOR_LONG,
        () -> {
          double deadlineS = settings.get().longOperatorDeadline();
          return new Expected(
              "operator", false, deadlineS > 0.0 ? deadlineS : Double.POSITIVE_INFINITY);
        });
  }

  private static HeartbeatWatch ofOperators(Hazard hazard, Supplier<Expected> expected) {
    return new HeartbeatWatch(
        hazard,
        expected,
        (message, any) ->
            message instanceof OperatorHeartbeat heartbeat
                ? Optional.of("\"" + heartbeat.operator() + "\"")
                : Optional.empty(),
        true);
  }

  /** Watches the health monitor, which watches all other services. */
  static HeartbeatWatch ofMonitor(Supplier<SafetyVariables> settings) {
    return new HeartbeatWatch(
        Hazard.HEALTH_MONITOR,
        () ->
            new Expected(
                settings.get().healthMonitorService(),
                settings.get().healthMonitorRequired(),
                settings.get().healthMonitorDeadline()),
        (message, expected) ->
            message instanceof HealthReport report
                    && report.status() == ServiceStatus.RUNNING
                    && report.serviceName().equals(expected.who())
                ? Optional.of(report.serviceName())
                : Optional.empty(),
        false);
  }

  @Override
  public Hazard hazard() {
    return hazard;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    sender
        .apply(message, expected.get())
        .ifPresent(
            who -> {
              silence.forget(heard);
              silence.hear(who, nowMicros);
              heard = who;
            });
  }

  /** The deadline for an operator's heartbeat starts when the pilot gives back control. */
  @Override
  public void pilotFlies(long nowMicros) {
    if (ofOperators && !heard.isEmpty()) {
      silence.hear(heard, nowMicros);
    }
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    silence.handOver(state, nowMicros);
  }

  /** Every source that has reported before must report again within the deadline. */
  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    silence.takeOver(state, nowMicros, upToDate ? 0.0 : expected.get().deadlineS());
    silence.heardMicros().keySet().forEach(who -> heard = who);
  }

  @Override
  public String saved() {
    return heard.isEmpty() ? "" : silence.isAssumed(heard) ? "assumed" : "heard";
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    Expected now = expected.get();
    if (heard.isEmpty()) {
      return now.required() ? Optional.of("no " + now.who() + " heard") : Optional.empty();
    }
    double silentS = Clock.seconds(nowMicros - silence.heardMicros().get(heard));
    return silentS > now.deadlineS()
        ? Optional.of(heard + " silent for " + CauseText.seconds(silentS))
        : Optional.empty();
  }
}
