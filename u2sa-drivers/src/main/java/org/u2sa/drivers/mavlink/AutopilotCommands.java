package org.u2sa.drivers.mavlink;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.interfaces.time.Clock;

/**
 * When which command message goes out: while commands hold, at their rate; when they end, neutral
 * for a time; then control is given back, and nothing more is said.
 */
final class AutopilotCommands {
  private static final int RELEASES = 3; // a datagram may be lost

  private final CommandForm form;
  private final long everyMicros;
  private final long neutralMicros;
  private final Consumer<Object> out;
  private boolean isWaiting;
  private boolean holds; // control: something was sent since it was given back
  private int releasesLeft;
  private long heldMicros; // when a command last held
  private long dueMicros = Long.MIN_VALUE;

  /**
   * @param everyS between two messages [s]
   * @param neutralS how long neutral is sent at the end [s]
   * @param out takes the messages
   */
  AutopilotCommands(CommandForm form, double everyS, double neutralS, Consumer<Object> out) {
    this.form = form;
    this.everyMicros = Clock.micros(everyS);
    this.neutralMicros = Clock.micros(neutralS);
    this.out = out;
  }

  /**
   * Sends what is due.
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

  /** Sends neutral at once, if anything was commanded. */
  void stop(CommandForm.Target target, long nowMicros) {
    if (holds) {
      sendNeutral(target, nowMicros);
      dueMicros = nowMicros + everyMicros;
    }
  }

  /** Neutral, and control is given back, at once: the service ends. */
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

  /** Whether a command holds that cannot be sent: too little is known of the vehicle. */
  boolean isWaiting() {
    return isWaiting;
  }
}
