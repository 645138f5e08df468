package org.u2sa.sim.marine;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * A propeller at the hull, in forward, right and down axes. Its thrust follows its command by a lag
 * of first order.
 *
 * @param name as commands address it
 * @param place from the reference point [m]
 * @param direction of its thrust on the hull at a positive command, of length 1
 * @param forwardN thrust at full command [N]
 * @param reverseN thrust at full command astern [N]
 * @param deadband share of the command below which it does not turn, 0…1
 * @param exponent of the thrust's growth with the command beyond the deadband
 * @param timeConstantS of the lag [s]
 */
public record VesselThruster(
    String name,
    Point place,
    Point direction,
    double forwardN,
    double reverseN,
    double deadband,
    double exponent,
    double timeConstantS) {
  private static final double UNIT = 1e-6;

  /**
   * @throws IllegalArgumentException if the direction is not of length 1 or a number out of range
   */
  public VesselThruster {
    Arguments.requireInside("deadband of " + name, deadband, 0.0, 0.9);
    Arguments.requireInside("exponent of " + name, exponent, 0.5, 4.0);
    Arguments.requirePositive("time constant of " + name, timeConstantS);
    Arguments.requireInside(
        "length of the direction of " + name, direction.distance(), 1.0 - UNIT, 1.0 + UNIT);
  }

  /** Thrust in the long run at a command −1…1 [N]. */
  double thrustN(double command) {
    double beyond = (StrictMath.abs(command) - deadband) / (1.0 - deadband);
    if (!(beyond > 0.0)) {
      return 0.0;
    }
    double share = StrictMath.pow(StrictMath.min(1.0, beyond), exponent);
    return command > 0.0 ? share * forwardN : -share * reverseN;
  }
}
