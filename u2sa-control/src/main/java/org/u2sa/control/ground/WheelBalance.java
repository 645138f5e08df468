package org.u2sa.control.ground;

import java.util.OptionalDouble;
import org.u2sa.control.Transfer;
import org.u2sa.service.handover.HandOver;

/**
 * Corrects the yaw rate of two motors for mismatch and load, by three integrals of the yaw-rate
 * error; the integral is the heading error, so a noisy compass does no harm.
 *
 * <ul>
 *   <li>Mismatch: relative weakness of one motor, in proportion to its command. Kept at standstill
 *       and in turns, because motors do not change.
 *   <li>Bias: turning independent of speed, such as on a side slope. Only while driving.
 *   <li>Push: extra effort to turn in place, where wheels scrub under load. Kept from turn to turn,
 *       for both directions.
 * </ul>
 *
 * None of them moves a vehicle commanded to stop.
 */
final class WheelBalance {
  /** Share of command at which mismatch and bias absorb equal parts of an error. */
  private static final double EQUAL_PARTS = 0.15;

  private double mismatch;
  private double bias;
  private double push;
  private double smoothRadPerS; // low-pass filtered yaw-rate error

  /**
   * Gains and limits.
   *
   * @param proportional extra yaw rate commanded per rad/s of error
   * @param smoothingS filter time of the error for that [s]
   * @param driving fraction of an error corrected per second while driving [1/s]; 0: no feedback
   * @param turning fraction corrected per second in turns in place [1/s]
   * @param mostMismatch limit of the mismatch, 0…1
   * @param sharePerRadPerS additional command fraction of each motor per yaw rate
   * @param mostAtOnceRadPerS limit of the yaw rate that the proportional part commands [rad/s]
   * @param mostTurning limit of the command in a turn in place, 0…1
   */
  record Settings(
      double proportional,
      double smoothingS,
      double driving,
      double turning,
      double mostMismatch,
      double sharePerRadPerS,
      double mostAtOnceRadPerS,
      double mostTurning) {}

  /** Saves or restores the learnt mismatch, which is valid for every control system. */
  void transfer(Transfer state) {
    mismatch = state.number("MISMATCH", mismatch);
    bias = state.number("BIAS", bias);
    push = state.number("PUSH", push);
  }

  /**
   * Continues from another control system.
   *
   * @param isSwap whether it moved the vehicle until now; otherwise only the mismatch of the motors
   *     is still valid
   */
  void takeOver(HandOver state, boolean isSwap) {
    transfer(Transfer.restoring(state));
    if (!isSwap) {
      bias = 0.0;
      push = 0.0;
    }
  }

  /** Resets the push for the next attempt to turn. */
  void relax() {
    push = 0.0;
  }

  /**
   * Computes the wheel commands.
   *
   * @param wanted shares by calibration alone
   * @param ahead common command fraction of both motors, negative in reverse; 0 at standstill or in
   *     a turn in place
   * @param errorRadPerS wanted minus actual yaw rate, left positive; empty if unknown, or if the
   *     motors do not obey
   */
  WheelShares step(
      WheelShares wanted,
      double ahead,
      OptionalDouble errorRadPerS,
      Settings settings,
      double stepS) {
    if (wanted.effort() == 0.0) {
      bias = 0.0;
      smoothRadPerS = 0.0;
      return wanted;
    }
    forgetSwitchedOff(settings);
    if (errorRadPerS.isPresent()) {
      double newer = stepS / (settings.smoothingS() + stepS);
      smoothRadPerS += newer * (errorRadPerS.getAsDouble() - smoothRadPerS);
    }
    double atOnce = settings.sharePerRadPerS() * atOnceRadPerS(settings);
    double error = errorRadPerS.orElse(0.0) * settings.sharePerRadPerS() * stepS;
    if (ahead == 0.0) {
      bias = 0.0;
      double direction = Math.signum(wanted.right() - wanted.left());
      double most = Math.max(settings.mostTurning(), wanted.effort());
      double room = most - wanted.effort(); // anti-windup
      push = bounded(push + settings.turning() * direction * error, -wanted.effort(), room);
      double turn = bounded(push + direction * atOnce, -wanted.effort() - most, room);
      return balanced(wanted, direction * turn);
    }
    double both = ahead * ahead + EQUAL_PARTS * EQUAL_PARTS;
    mismatch -= settings.driving() * error * ahead / both; // in reverse the weaker one turns back
    mismatch = bounded(mismatch, -settings.mostMismatch(), settings.mostMismatch());
    bias += settings.driving() * error * EQUAL_PARTS * EQUAL_PARTS / both;
    bias = bounded(bias, -1.0, 1.0);
    return balanced(wanted, bias + atOnce);
  }

  /** Proportional part [rad/s], bounded because the measured yaw rate may be wrong. */
  private double atOnceRadPerS(Settings settings) {
    double most = settings.mostAtOnceRadPerS();
    return bounded(settings.proportional() * smoothRadPerS, -most, most);
  }

  private void forgetSwitchedOff(Settings settings) {
    if (settings.driving() == 0.0) {
      mismatch = 0.0;
      bias = 0.0;
    }
    if (settings.turning() == 0.0) {
      push = 0.0;
    }
  }

  private WheelShares balanced(WheelShares wanted, double turn) {
    return new WheelShares(
        wanted.left() * (1.0 + mismatch) - turn, wanted.right() * (1.0 - mismatch) + turn);
  }

  private static double bounded(double value, double least, double most) {
    return Math.max(least, Math.min(most, value));
  }
}
