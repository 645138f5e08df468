package org.u2sa.sim.marine;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * A thruster on the hull, in forward, right, down axes, with first-order lag.
 *
 * @param name name used in commands
 * @param place position relative to the reference point [m]
 * @param direction unit vector of the thrust on the hull at a positive command
 * @param forwardN thrust at full command [N]
 * @param reverseN thrust at full astern command [N]
 * @param deadband command magnitude below which it does not turn, 0…1
 * @param exponent exponent of the thrust curve beyond the dead band
 * @param timeConstantS time constant of the lag [s]
 * @param fullPowerW electrical power at full command [W]; 0: unknown
 */
public record VesselThruster(
    String name,
    Point place,
    Point direction,
    double forwardN,
    double reverseN,
    double deadband,
    double exponent,
    double timeConstantS,
    double fullPowerW)
    implements VesselActuator {
  private static final double UNIT = 1e-6;

  /**
   * @throws IllegalArgumentException if the direction is not a unit vector or a value is out of
   *     range
   */
  public VesselThruster {
    Arguments.requireInside("deadband of " + name, deadband, 0.0, 0.9);
    Arguments.requireInside("exponent of " + name, exponent, 0.5, 4.0);
    Arguments.requirePositive("time constant of " + name, timeConstantS);
    Arguments.requireInside(
        "length of the direction of " + name, direction.distance(), 1.0 - UNIT, 1.0 + UNIT);
  }

  /** {@inheritDoc} The thrust [N]. */
  @Override
  public double level(double command) {
    double beyond = (StrictMath.abs(command) - deadband) / (1.0 - deadband);
    if (!(beyond > 0.0)) {
      return 0.0;
    }
    double share = StrictMath.pow(StrictMath.min(1.0, beyond), exponent);
    return command > 0.0 ? share * forwardN : -share * reverseN;
  }

  /**
   * {@inheritDoc} Power grows with thrust to the power of 3/2, as for an ideal propeller at rest.
   */
  @Override
  public OptionalDouble powerW(double level) {
    double share = level > 0.0 ? level / forwardN : level < 0.0 ? -level / reverseN : 0.0;
    return fullPowerW > 0.0
        ? OptionalDouble.of(fullPowerW * share * StrictMath.sqrt(share))
        : OptionalDouble.empty();
  }

  @Override
  public void act(double level, double u, double v, double w, double[] force) {
    VesselActuator.push(level, direction, place, force);
  }
}
