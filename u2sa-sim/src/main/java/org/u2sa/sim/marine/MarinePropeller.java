package org.u2sa.sim.marine;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * A propeller in open water whose thrust and torque fall with its advance (Fossen 2021, section
 * 9.4): ρ D⁴ n² K_T(J) and ρ D⁵ n² K_Q(J), both linear in J; astern as at J = 0. Its speed lags the
 * command.
 *
 * @param name name used in commands
 * @param place position relative to the reference point [m]
 * @param direction unit vector of the thrust on the hull at a positive command
 * @param diameterM [m]
 * @param thrustAtRest K_T at J = 0
 * @param thrustSlope dK_T/dJ
 * @param torqueAtRest K_Q at J = 0, the part that turns the hull about the direction
 * @param torqueSlope dK_Q/dJ
 * @param wake wake fraction: fraction by which the inflow behind the hull is slower
 * @param deduction thrust deduction fraction, due to suction on the hull
 * @param fullSpeedRevPerS at full command [1/s]
 * @param densityKgPerM3 water density [kg/m³]
 * @param timeConstantS time constant of its speed [s]
 * @param fullPowerW electrical power at full speed [W]; 0: unknown
 */
public record MarinePropeller(
    String name,
    Point place,
    Point direction,
    double diameterM,
    double thrustAtRest,
    double thrustSlope,
    double torqueAtRest,
    double torqueSlope,
    double wake,
    double deduction,
    double fullSpeedRevPerS,
    double densityKgPerM3,
    double timeConstantS,
    double fullPowerW)
    implements VesselActuator {
  /**
   * @throws IllegalArgumentException if a value is out of range
   */
  public MarinePropeller {
    Arguments.requirePositive("diameter of " + name + " [m]", diameterM);
    Arguments.requirePositive("thrust coefficient of " + name, thrustAtRest);
    Arguments.requireInside("wake of " + name, wake, 0.0, 0.9);
    Arguments.requireInside("deduction of " + name, deduction, 0.0, 0.9);
    Arguments.requirePositive("full speed of " + name + " [1/s]", fullSpeedRevPerS);
    Arguments.requirePositive("density at " + name + " [kg/m^3]", densityKgPerM3);
    Arguments.requirePositive("time constant of " + name, timeConstantS);
  }

  /** {@inheritDoc} The speed [1/s]. */
  @Override
  public double level(double command) {
    return fullSpeedRevPerS * command;
  }

  /** {@inheritDoc} Power grows with the cube of the speed. */
  @Override
  public OptionalDouble powerW(double level) {
    double share = StrictMath.abs(level) / fullSpeedRevPerS;
    return fullPowerW > 0.0
        ? OptionalDouble.of(fullPowerW * share * share * share)
        : OptionalDouble.empty();
  }

  @Override
  public void act(double level, double u, double v, double w, double[] force) {
    double along = u * direction.x() + v * direction.y() + w * direction.z();
    double inflow = level > 0.0 ? (1.0 - wake) * StrictMath.max(0.0, along) / diameterM : 0.0;
    double speed = StrictMath.abs(level);
    double d4 = densityKgPerM3 * diameterM * diameterM * diameterM * diameterM;
    double newtons = d4 * speed * (thrustAtRest * level + thrustSlope * inflow);
    VesselActuator.push((1.0 - deduction) * newtons, direction, place, force);
    double torque = d4 * diameterM * speed * (torqueAtRest * level + torqueSlope * inflow);
    force[3] += torque * direction.x();
    force[4] += torque * direction.y();
    force[5] += torque * direction.z();
  }
}
