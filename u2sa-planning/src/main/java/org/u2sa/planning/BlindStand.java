package org.u2sa.planning;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.service.U2SAService;

/**
 * Detects when an obstacle-avoiding planner must stop because its surroundings are unknown: the
 * World Modeler is silent, or lacks a sensor.
 */
final class BlindStand {
  private final U2SAService planner;
  private final Avoidance avoidance;
  private final BooleanSupplier looksOut; // whether surroundings must be known
  private final Supplier<AvoidanceVariables> settings;
  private String said = "";

  BlindStand(
      U2SAService planner,
      Avoidance avoidance,
      BooleanSupplier looksOut,
      Supplier<AvoidanceVariables> settings) {
    this.planner = planner;
    this.avoidance = avoidance;
    this.looksOut = looksOut;
    this.settings = settings;
  }

  /**
   * Whether to stop now; reports each change to the operator.
   *
   * @param failsafe LAND continues, as does RETURN if the vehicle cannot stop, because circling
   *     would never end
   */
  boolean stands(FailsafeAction failsafe, long nowMicros) {
    Optional<String> trouble =
        looksOut.getAsBoolean()
            ? avoidance.world().age().trouble(nowMicros, settings.get().worldStaleMicros())
            : Optional.empty();
    boolean goesOn =
        failsafe == FailsafeAction.LAND
            || failsafe == FailsafeAction.RETURN && !settings.get().stops();
    tell(trouble.map(what -> (goesOn ? "continues blind: " : "stands: ") + what).orElse(""));
    return trouble.isPresent() && !goesOn;
  }

  private void tell(String what) {
    if (what.equals(said)) {
      return;
    }
    if (what.isEmpty()) {
      planner.log(LogLevelEnum.WARN, "surroundings known again: continues");
      avoidance.begin(); // time without them is not lack of progress
    } else {
      planner.trouble(what);
    }
    planner.remark("world", what);
    said = what;
  }

  /** Whether the vehicle can stop, rather than circle. */
  boolean brakes() {
    return settings.get().stops();
  }
}
