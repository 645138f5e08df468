package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ObeyedOrders;

/**
 * Arming state: the vehicle may move once all checks have passed and an operator or ARM AT START
 * has armed it.
 */
final class Arming {
  private static final String WAITS = "waits to arm";
  private static final String OBEYED = "obeyed orders to arm";

  private final SafetyManager manager;
  private final ArmingChecks checks;
  private final ObeyedOrders obeyed = new ObeyedOrders(); // to arm
  private boolean armed;
  private boolean waits; // whether to arm automatically once the checks pass
  private int waitsForReasons; // number of reasons last logged
  private boolean saidArmed;
  private int saidReasons = -1;

  Arming(SafetyManager manager, ArmingChecks checks, boolean atStart) {
    this.manager = manager;
    this.checks = checks;
    waits = atStart;
  }

  void see(U2SAData message, long nowMicros) {
    checks.see(message, nowMicros);
  }

  boolean isArmed() {
    return armed;
  }

  /** Arms if all checks pass. */
  void arm(long nowMicros) {
    if (armed) {
      return;
    }
    List<String> reasons = checks.reasons(nowMicros);
    if (reasons.isEmpty()) {
      armed = true;
      waits = false;
      manager.log("armed");
    } else {
      manager.log(LogLevelEnum.WARN, "not armed: " + String.join("; ", reasons));
    }
  }

  /**
   * Remembers an order to arm that arrived in time; returns whether it arrived for the first time.
   */
  boolean isNew(ArmCommand command) {
    return obeyed.add(command.requestId(), command);
  }

  void handOver(HandOver state) {
    state.flag(WAITS, waits);
    state.texts(OBEYED, obeyed.identities());
  }

  /**
   * Remembers the orders that the predecessor obeyed, and after a swap continues to wait if it did.
   */
  void takeOver(HandOver state, boolean isSwap) {
    waits = isSwap ? state.flag(WAITS) : waits;
    obeyed.takeOver(state.texts(OBEYED));
  }

  /** ARM AT START counts only for the first Safety Manager of a run. */
  void startsLater(String why) {
    if (waits) {
      waits = false;
      manager.log(LogLevelEnum.WARN, "does not arm at start: " + why);
    }
  }

  /** Resumes armed, like the previous Safety Manager. */
  void stayArmed() {
    armed = true;
    waits = false;
    manager.log("still armed, as the previous Safety Manager was");
  }

  /** If ARM AT START is set, arms once, when the checks first pass. */
  void armAtStart(long nowMicros) {
    if (!waits) {
      return;
    }
    List<String> reasons = checks.reasons(nowMicros);
    if (reasons.isEmpty()) {
      arm(nowMicros);
    } else if (reasons.size() != waitsForReasons) { // the numbers in the reasons change continually
      manager.log("waiting to arm: " + String.join("; ", reasons));
      waitsForReasons = reasons.size();
    }
  }

  void disarm(String why) {
    waits = false;
    if (armed) {
      armed = false;
      manager.log(LogLevelEnum.WARN, "disarmed: " + why);
    }
  }

  /** Whether {@link #state} would differ from the last one, ignoring numbers. */
  boolean hasChanged(long nowMicros) {
    return armed != saidArmed || reasons(nowMicros).size() != saidReasons;
  }

  ArmingState state(long nowMicros) {
    List<String> reasons = reasons(nowMicros);
    saidArmed = armed;
    saidReasons = reasons.size();
    return new ArmingState().armed(armed).reasons(reasons);
  }

  private List<String> reasons(long nowMicros) {
    return armed ? new ArrayList<>() : checks.reasons(nowMicros);
  }
}
