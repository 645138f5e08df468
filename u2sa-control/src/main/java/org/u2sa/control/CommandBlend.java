package org.u2sa.control;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/**
 * Stores the last commands, and blends from another control system's commands to this one's
 * (bumpless transfer), so that surfaces do not jump when one law takes over from another.
 */
final class CommandBlend {
  private static final String NAME = "COMMAND ";

  private final Map<String, Double> last = new LinkedHashMap<>(); // [%] by actuator
  private final Map<String, Double> from = new LinkedHashMap<>(); // the other system's commands
  private long beganMicros = Clock.NEVER;

  /** Saves the last commands for the control system that takes over. */
  void handOver(HandOver state) {
    state.texts("COMMANDED", last.keySet());
    last.forEach((actuator, percentage) -> state.number(NAME + actuator, percentage));
  }

  /**
   * Reads the last commands of the previous control system.
   *
   * @param alike whether the predecessor had the same class; if so, its state is complete and
   *     nothing is blended
   */
  void takeOver(HandOver state, boolean alike) {
    for (String actuator : state.texts("COMMANDED")) {
      state.number(NAME + actuator).ifPresent(percentage -> last.put(actuator, percentage));
    }
    if (!alike) {
      from.putAll(last);
    }
  }

  /** Ends the blend: from now on, commands are those of the current law. */
  void end() {
    from.clear();
  }

  /** Last command [%]. */
  OptionalDouble last(String actuator) {
    Double percentage = last.get(actuator);
    return percentage == null ? OptionalDouble.empty() : OptionalDouble.of(percentage);
  }

  /**
   * Command for now [%].
   *
   * @param wanted command of the current law [%]
   * @param spanS duration of the blend [s]; 0 for none
   */
  double command(String actuator, double wanted, long nowMicros, double spanS) {
    double commanded = wanted;
    if (!from.isEmpty()) {
      beganMicros = Math.min(beganMicros, nowMicros);
      double sinceS = Clock.seconds(nowMicros - beganMicros);
      if (sinceS >= spanS) {
        from.clear();
      } else {
        double before = from.getOrDefault(actuator, wanted);
        commanded = before + sinceS / spanS * (wanted - before);
      }
    }
    last.put(actuator, commanded);
    return commanded;
  }
}
