package org.u2sa.core.safety;

import java.util.List;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;

/**
 * Last retained messages of the previous Safety Manager, so that a restart in flight neither
 * disarms the vehicle nor drops a failsafe. Messages older than a restart takes, or that far ahead
 * of this clock, are from another run.
 */
final class Predecessor {
  private static final double LISTEN_S = 0.5; // until a broker has sent retained messages
  private static final double SPOKE_WITHIN_S = 20.0;

  private final long listensUntilMicros;
  private boolean awaited = true;
  private boolean armed;
  private FailsafeAction action = FailsafeAction.CONTINUE;
  private List<String> causes = List.of();

  Predecessor(long nowMicros) {
    listensUntilMicros = nowMicros + Clock.micros(LISTEN_S);
  }

  void see(U2SAData message, long nowMicros) {
    long ageMicros = nowMicros - message.timestamp().orElse(Long.MIN_VALUE / 2);
    if (!awaited || Math.abs(ageMicros) > Clock.micros(SPOKE_WITHIN_S)) {
      return;
    }
    if (message instanceof ArmingState state) {
      armed = state.armed();
    } else if (message instanceof FailsafeState state) {
      action = state.action();
      causes = state.causes();
    }
  }

  /** Whether its messages may still arrive. */
  boolean isAwaited(long nowMicros) {
    awaited &= nowMicros < listensUntilMicros;
    return awaited;
  }

  /** Ignores it from now on. */
  void end() {
    awaited = false;
    armed = false;
    action = FailsafeAction.CONTINUE;
  }

  boolean wasArmed() {
    return armed;
  }

  /** Last failsafe action it demanded. */
  FailsafeAction action() {
    return action;
  }

  /** Causes of the action, most severe first. */
  List<String> causes() {
    return causes;
  }
}
