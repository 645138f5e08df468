package org.u2sa.core.health;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/**
 * Demands a failsafe action when the Safety Manager has failed, stopped or become unreachable while
 * the vehicle is armed, because nobody else monitors battery, fence and operator link. Ends when a
 * Safety Manager is heard again.
 */
final class SafetyManagerLoss {
  private static final double REPEAT_INTERVAL_S = 1.0;
  private static final double SPOKE_WITHIN_S = 20.0;

  private final boolean isRestart;
  private boolean armed;
  private FailsafeAction demanded =
      FailsafeAction.CONTINUE; // according to the last failsafe received
  private double heardS; // or excused
  private double repeatDueS = Double.NEGATIVE_INFINITY;

  /**
   * @param isRestart whether the monitor ran before in this run, so that retained messages are from
   *     this run, regardless of age
   */
  SafetyManagerLoss(boolean isRestart) {
    this.isRestart = isRestart;
  }

  void hear(ArmingState state, long nowMicros) {
    double nowS = Clock.seconds(nowMicros);
    boolean isOfThisRun =
        isRestart || nowS - state.timestamp().orElse(nowMicros) / 1e6 <= SPOKE_WITHIN_S;
    armed = state.armed() && isOfThisRun;
    heardS = nowS;
    repeatDueS = Double.NEGATIVE_INFINITY;
  }

  void hear(FailsafeState state) {
    demanded = state.action();
  }

  /** Excuses silence until the given time, because the monitor could not receive reports. */
  void excuse(double untilS) {
    heardS = Math.max(heardS, untilS);
  }

  /** Whether the vehicle is armed, as far as the Safety Manager has published. */
  boolean isArmed() {
    return armed;
  }

  /** Whether the Safety Manager of an armed vehicle is lost. */
  boolean isLost(MonitorVariables.Limits limits, double nowS) {
    return armed && nowS - heardS > limits.safetyManagerDeadline();
  }

  /** The failsafe to publish now, no less severe than the last one demanded; empty if none. */
  Optional<FailsafeState> due(MonitorVariables.Limits limits, double nowS) {
    FailsafeAction action = FailsafeAction.valueOf(limits.onSafetyManagerLoss());
    if (!isLost(limits, nowS) || action == FailsafeAction.CONTINUE || nowS < repeatDueS) {
      return Optional.empty();
    }
    repeatDueS = nowS + REPEAT_INTERVAL_S;
    FailsafeAction worse = demanded.compareTo(action) > 0 ? demanded : action;
    return Optional.of(
        new FailsafeState()
            .action(worse)
            .causes(List.of("safety manager: silent for " + Math.round(nowS - heardS) + " s")));
  }
}
