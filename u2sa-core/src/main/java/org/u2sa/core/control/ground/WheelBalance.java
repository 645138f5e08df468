package org.u2sa.core.control.ground;

import java.util.OptionalDouble;
import org.u2sa.service.HandOver;

/**
 * Makes two motors turn the vehicle as fast as it is to turn, whatever they are like and whatever
 * it carries: three integrals of the error of the yaw rate, which is the error of the heading, so
 * that a noisy compass harms none.
 *
 * <ul>
 *   <li>Mismatch: by how much one motor is weaker, in proportion to what it is commanded. Kept
 *       while the vehicle stands and turns: motors stay as they are.
 *   <li>Bias: what turns the vehicle however fast it is, such as a slope from the side. Only while
 *       it drives.
 *   <li>Push: what it takes to turn on the spot, where wheels scrub under their load. Kept from
 *       turn to turn, for both directions.
 * </ul>
 *
 * None of them moves a vehicle that is to stand.
 */
final class WheelBalance {
  /** Share at which mismatch and bias take the same part of an error. */
  private static final double EQUAL_PARTS = 0.15;

  private double mismatch;
  private double bias;
  private double push;
  private double smoothRadPerS; // error of the yaw rate, without most of the compass's noise

  /**
   * Gains and limits.
   *
   * @param proportional yaw rate commanded more for each rad/s that is lacking
   * @param smoothingS over which an error is averaged for that [s]
   * @param driving share of an error corrected per second [1/s]; 0: no feedback
   * @param turning the same of turns on the spot [1/s]
   * @param mostMismatch 0…1
   * @param sharePerRadPerS by which each motor must be commanded more for a yaw rate
   */
  record Settings(
      double proportional,
      double smoothingS,
      double driving,
      double turning,
      double mostMismatch,
      double sharePerRadPerS) {}

  void handOver(HandOver state) {
    state.number("MISMATCH", mismatch).number("BIAS", bias).number("PUSH", push);
  }

  /** Motors are as they are whichever control drives them. */
  void takeOver(HandOver state) {
    mismatch = state.number("MISMATCH").orElse(0.0);
    bias = state.number("BIAS").orElse(0.0);
    push = state.number("PUSH").orElse(0.0);
  }

  /** Begins the next attempt to turn with no push. */
  void relax() {
    push = 0.0;
  }

  /**
   * What to command.
   *
   * @param wanted by calibration alone
   * @param ahead share of both motors that drives ahead; 0: it turns on the spot, or stands
   * @param errorRadPerS wanted yaw rate less the true one, to the left positive; empty if unknown,
   *     or if the motors are not obeying
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
    double atOnce = settings.proportional() * settings.sharePerRadPerS() * smoothRadPerS;
    double error = errorRadPerS.orElse(0.0) * settings.sharePerRadPerS() * stepS;
    if (ahead == 0.0) {
      bias = 0.0;
      double direction = Math.signum(wanted.right() - wanted.left());
      double room = 1.0 - wanted.effort(); // beyond, it would only be wound up
      push = bounded(push + settings.turning() * direction * error, -wanted.effort(), room);
      return balanced(wanted, direction * push + atOnce);
    }
    double both = ahead * ahead + EQUAL_PARTS * EQUAL_PARTS;
    mismatch -= settings.driving() * error * Math.abs(ahead) / both;
    mismatch = bounded(mismatch, -settings.mostMismatch(), settings.mostMismatch());
    bias += settings.driving() * error * EQUAL_PARTS * EQUAL_PARTS / both;
    bias = bounded(bias, -1.0, 1.0);
    return balanced(wanted, bias + atOnce);
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
