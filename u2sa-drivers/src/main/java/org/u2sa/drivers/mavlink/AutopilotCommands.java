package org.u2sa.drivers.mavlink;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Predicate;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/**
 * Schedules command messages: at their rate while commands are valid, then neutral for a while,
 * then control is released.
 */
final class AutopilotCommands {
  private static final int RELEASES = 3; // a datagram may be lost
  private static final String HOLDS = "AUTOPILOT HELD";
  private static final String HELD_FOR = "AUTOPILOT HELD FOR"; // since the last command [s]

  private final CommandForm form;
  private final long everyMicros;
  private final long neutralMicros;
  private final Predicate<Object> out;
  private boolean isWaiting;
  private boolean holds; // in control: something was sent since the last release
  private boolean isInherited; // holds, but has not yet been able to send
  private long inheritedMicros; // time since the predecessor's last command
  private int releasesLeft;
  private long heldMicros; // time of the last valid command
  private long dueMicros = Long.MIN_VALUE;

  /**
   * @param everyS interval between messages [s]
   * @param neutralS duration of neutral at the end [s]
   * @param out sends a message; returns false if the link rejected it
   */
  AutopilotCommands(CommandForm form, double everyS, double neutralS, Predicate<Object> out) {
    this.form = form;
    this.everyMicros = Clock.micros(everyS);
    this.neutralMicros = Clock.micros(neutralS);
    this.out = out;
  }

  /**
   * Releases commands of a predecessor that transferred no state, without sending neutral, because
   * a radio pilot may be in control.
   */
  void inherit() {
    inherit(neutralMicros);
  }

  /** Sends neutral before releasing inherited commands, as an emergency stop demands. */
  void endInNeutral() {
    if (isInherited) {
      inheritedMicros = 0L;
    }
  }

  private void inherit(long sinceCommandMicros) {
    holds = !form.axes().isEmpty();
    isInherited = holds;
    inheritedMicros = sinceCommandMicros;
    releasesLeft = RELEASES;
  }

  /** Saves whether it is in control, and for how long it has had no command. */
  void handOver(HandOver state, long nowMicros) {
    state.flag(HOLDS, holds);
    if (holds) {
      state.number(HELD_FOR, Clock.seconds(heldForMicros(nowMicros)));
    }
  }

  /** Restores the state saved by {@link #handOver}, if present. */
  void takeOver(HandOver state) {
    if (state.flag(HOLDS)) {
      inherit(Clock.micros(state.number(HELD_FOR).orElse(0.0)));
    } else if (state.names().contains(HOLDS)) {
      holds = false;
      isInherited = false;
    }
  }

  /** Time without a command; does not advance until the link has accepted the first message. */
  private long heldForMicros(long nowMicros) {
    return isInherited ? inheritedMicros : nowMicros - heldMicros;
  }

  /**
   * Sends due messages.
   *
   * @param percentages percentage of each actuator by name; empty without a command
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
      isInherited = false;
      releasesLeft = RELEASES;
      heldMicros = nowMicros;
      out.test(form.message(target, percentages, nowMicros));
    } else if (holds && heldForMicros(nowMicros) < neutralMicros) {
      sendNeutral(target, nowMicros);
    } else if (holds) {
      release(target);
    } else {
      return;
    }
    dueMicros = nowMicros + everyMicros;
  }

  /** A release that the link rejected does not count, and is sent again. */
  private void release(CommandForm.Target target) {
    List<Object> release = form.release(target);
    boolean isAccepted = true;
    for (Object message : release) {
      isAccepted &= out.test(message);
    }
    if (isAccepted) {
      releasesLeft--;
    }
    holds = releasesLeft > 0 && !release.isEmpty();
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
      form.release(target).forEach(out::test);
      holds = false;
    }
  }

  private void sendNeutral(CommandForm.Target target, long nowMicros) {
    if (form.isReady(nowMicros)
        && out.test(form.message(target, name -> OptionalDouble.empty(), nowMicros))
        && isInherited) {
      isInherited = false;
      heldMicros = nowMicros - inheritedMicros;
    }
  }

  /** Whether a valid command cannot be sent because the vehicle's state is unknown. */
  boolean isWaiting() {
    return isWaiting;
  }
}
