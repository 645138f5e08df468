package org.u2sa.scenarios.ugv;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundState;

/**
 * Whether a vehicle moves that is not armed: after an emergency stop, or before anybody armed it.
 * It has a moment to come to rest. A vehicle without brakes that rolls down a slope while its
 * motors are neutral or off is not moved by anybody. Belongs to one thread.
 */
final class UnarmedMotion {
  private static final double SLOWEST_MPS = 0.02;
  private static final double SLOWEST_RADPS = 0.05;
  private static final double AT_REST_WITHIN_S = 2.0;
  private static final double LEVEL =
      0.03; // rise over run; less than what rolling resistance holds

  private final List<String> violations = new ArrayList<>();
  private boolean armed;
  private double disarmedS = Double.NEGATIVE_INFINITY;
  private boolean said;

  /** Whether a vehicle moves at all. */
  static boolean moves(GroundState truth) {
    return truth.speedMps() > SLOWEST_MPS || Math.abs(truth.yawRateRadPerS()) > SLOWEST_RADPS;
  }

  /** Takes note of whether it is armed. */
  void see(ArmingState state, GroundState truth) {
    if (armed && !state.armed()) {
      disarmedS = truth.timeS();
      said = false;
    }
    armed = state.armed();
  }

  /**
   * Takes note of the truth.
   *
   * @param motors what reaches the motors
   * @param rise of the ground where the vehicle is, over run
   */
  void see(GroundState truth, DriveCommand motors, double rise) {
    boolean rolls = rise > LEVEL && rests(motors.first()) && rests(motors.second());
    boolean mayMove = armed || rolls || truth.timeS() - disarmedS < AT_REST_WITHIN_S;
    if (!mayMove && moves(truth) && !said) {
      said = true;
      violations.add(
          String.format(
              Locale.ROOT,
              "moved unarmed at %.1f s, at %.2f m/s",
              truth.timeS(),
              truth.speedMps()));
    }
  }

  private static boolean rests(double motor) {
    return motor == 0.0 || Double.isNaN(motor);
  }

  /** Each such motion, in words. */
  List<String> violations() {
    return violations;
  }
}
