package org.u2sa.planning.flight;

import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Notices a take-off that does not begin although the vehicle is armed, as that of a ground
 * vehicle. It is not given up: an engine may still have to start. Confined to the planner's thread.
 */
public final class TakeOffWatch {
  private static final double RISES_M = 1.0;
  private static final double ROLLS_MPS = 5.0;
  private static final double PATIENCE_S = 60.0;

  private String goal = "";
  private OptionalDouble fromUpM = OptionalDouble.empty();
  private long stoodMicros; // since when
  private boolean isSaid;

  /**
   * Processes a state.
   *
   * @return remark for the operator, once for each goal; otherwise empty
   */
  public String step(GoalInformation pursued, Vehicle vehicle, boolean armed) {
    OptionalDouble upM = vehicle.place().upM();
    if (!(pursued instanceof TakeOff) || upM.isEmpty()) {
      goal = "";
      return "";
    }
    long now = vehicle.timestampMicros();
    if (!goal.equals(pursued.uid())) {
      goal = pursued.uid();
      fromUpM = upM;
      stoodMicros = now;
      isSaid = false;
    }
    boolean moves =
        upM.getAsDouble() > fromUpM.getAsDouble() + RISES_M || vehicle.speedMps() > ROLLS_MPS;
    if (!armed || moves) {
      stoodMicros = now;
    }
    if (isSaid || Clock.seconds(now - stoodMicros) <= PATIENCE_S) {
      return "";
    }
    isSaid = true;
    return "armed, but on the ground for a minute: expected an aircraft that takes off";
  }
}
