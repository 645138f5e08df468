package org.u2sa.control.ground;

import java.util.Optional;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ObeyedOrders;
import org.u2sa.service.inbox.StreamDelay;

/**
 * Driving by hand: starts and ends by an operator's order, and also ends by a failsafe or when the
 * vehicle is disarmed. Only the operator who started it is obeyed; if that operator falls silent,
 * the vehicle stops.
 */
final class HandDriving {
  /** Limits of driving by hand. */
  record Limits(
      @Variable(unit = "m/s", min = 0.05, max = 50, ifAbsent = 1)
          @Description("Maximum speed when driven by hand.")
          double manualSpeed,
      @Variable(unit = "deg/s", min = 1, max = 720, ifAbsent = 45)
          @Description("Maximum turn rate when driven by hand.")
          double manualTurnRate) {}

  private static final long DEAD_MAN_MICROS = 500_000;

  private static final String OBEYED = "ORDERS TO DRIVE BY HAND";

  private final ObeyedOrders obeyed = new ObeyedOrders(); // to begin
  private final HoldAfterDrive hold = new HoldAfterDrive();
  private boolean active;
  private String operator = "";
  private long takeovers;
  private ManualDrive newest; // null: none since startup
  private long heardMicros;
  private StreamDelay delay = new StreamDelay(); // of the operator's drives
  private boolean armed;
  private FailsafeAction failsafe = FailsafeAction.CONTINUE;

  /**
   * Carries out an order.
   *
   * @param late reason for refusing an order to begin; empty if it arrived in time
   */
  ManualState obey(ManualOrder order, Optional<String> late) {
    if (order.active() && late.isPresent()) {
      return state().reason(late.get());
    }
    if (order.active() && !obeyed.add(order.requestId(), order)) {
      return state(); // arrived again: it may have been ended since
    }
    if (order.active() && failsafe != FailsafeAction.CONTINUE) {
      return state().reason("the failsafe " + failsafe + " is in force");
    }
    if (order.active() && !(active && operator.equals(order.operator()))) {
      active = true;
      operator = order.operator();
      takeovers++;
      newest = null;
      delay = new StreamDelay();
      hold.begin();
    } else if (!order.active()) {
      active = false;
    }
    return state();
  }

  ManualState state() {
    return new ManualState().active(active).operator(operator).takeovers(takeovers);
  }

  boolean isActive() {
    return active;
  }

  /**
   * @param expiryS delay above which one counts as meant for another situation [s]
   */
  void see(ManualDrive drive, long nowMicros, double expiryS) {
    if (active && drive.operator().equals(operator) && !delay.isLate(drive, nowMicros, expiryS)) {
      newest = drive;
      heardMicros = nowMicros;
    }
  }

  void see(GoalList goals, long nowMicros) {
    hold.see(goals, nowMicros);
  }

  /** Whether to stand after a drive instead of obeying navigation; a failsafe has precedence. */
  boolean isHeld(long nowMicros) {
    return !active && hold.holds(nowMicros) && failsafe == FailsafeAction.CONTINUE;
  }

  /** New state if disarming ends driving by hand; otherwise empty. */
  Optional<ManualState> see(boolean nowArmed) {
    boolean disarmed = armed && !nowArmed;
    armed = nowArmed;
    return disarmed ? end("the vehicle was disarmed") : Optional.empty();
  }

  /** New state if the failsafe ends driving by hand; otherwise empty. */
  Optional<ManualState> see(FailsafeAction action) {
    failsafe = action;
    return action == FailsafeAction.CONTINUE ? Optional.empty() : end("failsafe " + action);
  }

  private Optional<ManualState> end(String reason) {
    boolean was = active;
    active = false;
    return was ? Optional.of(state().reason(reason)) : Optional.empty();
  }

  /** Commanded motion, within the limits; empty to stop. */
  Optional<Drive> wanted(Limits limits, long nowMicros) {
    if (!active || newest == null || nowMicros - heardMicros > DEAD_MAN_MICROS) {
      return Optional.empty();
    }
    double fastest = limits.manualSpeed();
    double tightest = Math.toRadians(limits.manualTurnRate());
    Drive drive =
        new Drive(
            bounded(newest.speed().orElse(newest.speedShare().orElse(0.0) * fastest), fastest),
            bounded(newest.turnRate().orElse(newest.turnShare().orElse(0.0) * tightest), tightest));
    return drive.isStanding() ? Optional.empty() : Optional.of(drive);
  }

  private static double bounded(double value, double bound) {
    return Math.max(-bound, Math.min(bound, value));
  }

  void handOver(HandOver state) {
    state.flag("BY HAND", active).text("DRIVER", operator).number("TAKEOVERS", takeovers);
    state.texts(OBEYED, obeyed.identities()).flag("HELD AFTER DRIVE", hold.isAwaited());
  }

  /**
   * Continues for a predecessor. Only a swap continues its drive: before a restart, the vehicle may
   * have been disarmed, or the driver have let go, so it stands until somebody takes over again.
   */
  void takeOver(HandOver state, boolean isSwap, long nowMicros) {
    boolean wasActive = state.flag("BY HAND");
    active = wasActive && isSwap;
    operator = state.text("DRIVER").orElse("");
    if (active) {
      hold.begin();
    } else {
      hold.await(state.flag("HELD AFTER DRIVE") || wasActive, nowMicros);
    }
    obeyed.takeOver(state.texts(OBEYED));
    takeovers = (long) state.number("TAKEOVERS").orElse(0.0);
  }
}
