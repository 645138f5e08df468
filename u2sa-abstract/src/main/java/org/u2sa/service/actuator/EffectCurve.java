package org.u2sa.service.actuator;

import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

/**
 * Thrust curve of an actuator: no effect inside the dead band, beyond it share = ((|u| − deadband)
 * / (100 − deadband))^exponent of the full effect.
 *
 * @param deadband dead band [%, 0…99]
 * @param exponent 1 is linear, about 2 for propellers
 * @param forwardN force at +100 % [N]; NaN if unknown
 * @param reverseN force at −100 %, positive [N]; NaN if unknown
 */
public record EffectCurve(double deadband, double exponent, double forwardN, double reverseN) {
  /** Linear curve with unknown force. */
  public static final EffectCurve LINEAR = new EffectCurve(0.0, 1.0, Double.NaN, Double.NaN);

  /** Smaller effects leave the actuator unmoved. */
  public static final double MIN_SHARE = 1.0e-3;

  private static final double FULL_PERCENT = 100.0;

  public static EffectCurve of(ActuatorAnnouncement announced) {
    double forward = announced.force().map(Point::distance).orElse(Double.NaN);
    double reverse = announced.reverseForce().map(Point::distance).orElse(forward);
    return new EffectCurve(
        announced.deadband().orElse(0.0), announced.exponent().orElse(1.0), forward, reverse);
  }

  /** Command [%], −100…100, for a fraction of the full effect, −1…1. */
  public double percent(double share) {
    double size = Math.min(1.0, Math.abs(share));
    if (size < MIN_SHARE) {
      return 0.0;
    }
    double grown = exponent == 1.0 ? size : Math.pow(size, 1.0 / exponent);
    return Math.copySign(deadband + (FULL_PERCENT - deadband) * grown, share);
  }

  /** Share of the full effect, −1…1, of a command [%], −100…100. */
  public double share(double percent) {
    double beyond = (Math.abs(percent) - deadband) / (FULL_PERCENT - deadband);
    if (beyond <= 0.0) {
      return 0.0;
    }
    double grown = exponent == 1.0 ? beyond : Math.pow(beyond, exponent);
    return Math.copySign(Math.min(1.0, grown), percent);
  }

  /** Command [%] for a force [N]; beyond ±100 if it exceeds the actuator's maximum. */
  public double percentOfForce(double forceN) {
    double share = forceN / (forceN < 0.0 ? reverseN : forwardN);
    return Math.abs(share) > 1.0 ? FULL_PERCENT * share : percent(share);
  }
}
