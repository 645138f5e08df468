package org.u2sa.drivers.mavlink;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.interfaces.time.Clock;

/**
 * Schedules command messages: at their rate while commands are valid, then neutral for a while,
 * then control is released.
 */
final class AutopilotCommands {
  private static final int RELEASES = 3; // a datagram may be lost

  private final CommandForm form;
  private final long everyMicros;
  private final long neutralMicros;
  private final Consumer<Object> out;
  private boolean isWaiting;
  private boolean holds; // in control: something was sent since the last release
  private int releasesLeft;
  private long heldMicros; // time of the last valid command
  private long dueMicros = Long.MIN_VALUE;

  /**
   * @param everyS interval between messages [s]
   * @param neutralS duration of neutral at the end [s]
   * @param out receives the messages
   */
  AutopilotCommands(CommandForm form, double everyS, double neutralS, Consumer<Object> out) {
    this.form = form;
    this.everyMicros = Clock.micros(everyS);
    this.neutralMicros = Clock.micros(neutralS);
    this.out = out;
  }

  /**
   * Sends due messages.
   *
   * @param percentages of each actuator by name; empty without a command
   */
  void step(
      CommandForm.Target target, Function<String, OptionalDouble> percentages, long nowMicros) {
    if (nowMicros < dueMicros) {
      return;
    }
    boolean isCommanded =
        form.axes().stream().anyMatch(axis -> percentages.apply(axis.name()).isPresent());
    isWaiting = isCommanded && !form.isReady(nowMicros);
    if (isCommanded && !isWaiting) {
      holds = true;
      releasesLeft = RELEASES;
      heldMicros = nowMicros;
      out.accept(form.message(target, percentages, nowMicros));
    } else if (holds && nowMicros - heldMicros < neutralMicros) {
      sendNeutral(target, nowMicros);
    } else if (holds) {
      List<Object> release = form.release(target);
      release.forEach(out);
      holds = --releasesLeft > 0 && !release.isEmpty();
    } else {
      return;
    }
    dueMicros = nowMicros + everyMicros;
  }

  /** Sends neutral immediately if in control. */
  void stop(CommandForm.Target target, long nowMicros) {
    if (holds) {
      sendNeutral(target, nowMicros);
      dueMicros = nowMicros + everyMicros;
    }
  }

  /** Sends neutral and releases control immediately, for shutdown. */
  void end(CommandForm.Target target, long nowMicros) {
    if (holds) {
      sendNeutral(target, nowMicros);
      form.release(target).forEach(out);
      holds = false;
    }
  }

  private void sendNeutral(CommandForm.Target target, long nowMicros) {
    if (form.isReady(nowMicros)) {
      out.accept(form.message(target, name -> OptionalDouble.empty(), nowMicros));
    }
  }

  /** Whether a valid command cannot be sent because the vehicle's state is unknown. */
  boolean isWaiting() {
    return isWaiting;
  }
}
