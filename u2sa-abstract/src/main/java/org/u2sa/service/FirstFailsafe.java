package org.u2sa.service;

import java.util.OptionalLong;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.FailsafeState;

/**
 * Ignores a retained failsafe of an earlier run: the first failsafe received in a run, if it is
 * old. A Safety Manager repeats its failsafe every second, so the next one counts even if its clock
 * is behind.
 */
public final class FirstFailsafe {
  private static final long MAX_AGE_MICROS = 5 * Clock.MICROS_PER_SECOND;

  private final U2SAService service;
  private final Clock clock;
  private boolean heardCurrent;
  private OptionalLong ignored = OptionalLong.empty(); // timestamp

  /** A restarted service accepts the state left by this run. */
  public FirstFailsafe(U2SAService service, ServiceContext context) {
    this.service = service;
    clock = context.clock();
    heardCurrent = context.isRestart() || context.isSwap();
  }

  /** Whether to obey the failsafe. */
  public boolean isOfThisRun(FailsafeState failsafe) {
    long now = clock.micros();
    long sent = failsafe.timestamp().orElse(now);
    if (heardCurrent || now - sent <= MAX_AGE_MICROS) {
      heardCurrent = true;
    } else if (ignored.isEmpty()) {
      ignored = OptionalLong.of(sent);
      service.log(
          LogLevelEnum.WARN,
          "ignored failsafe "
              + failsafe.action()
              + ": sent "
              + (now - sent) / Clock.MICROS_PER_SECOND
              + " s ago, by an earlier run");
    } else {
      heardCurrent = sent != ignored.getAsLong(); // else it is delivered again
    }
    return heardCurrent;
  }
}
