package org.u2sa.sim.marine;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * A rudder or stern plane with its servo (Fossen 2021, section 9.6): lift ½ ρ U² A C_L δ along its
 * direction and drag ½ ρ U² A C_L δ² astern, with U the speed in the plane of both.
 *
 * @param name name used in commands
 * @param place position relative to the reference point [m]
 * @param direction unit vector of the lift on the hull at a positive command, across the hull
 * @param areaM2 area [m²]
 * @param liftSlope lift coefficient by the deflection [1/rad]
 * @param travelRad deflection at full command [rad]
 * @param densityKgPerM3 water density [kg/m³]
 * @param timeConstantS time constant of the servo [s]
 */
public record Fin(
    String name,
    Point place,
    Point direction,
    double areaM2,
    double liftSlope,
    double travelRad,
    double densityKgPerM3,
    double timeConstantS)
    implements VesselActuator {
  /**
   * @throws IllegalArgumentException if a value is out of range
   */
  public Fin {
    Arguments.requirePositive("area of " + name + " [m^2]", areaM2);
    Arguments.requirePositive("lift slope of " + name, liftSlope);
    Arguments.requireInside("travel of " + name + " [rad]", travelRad, 0.0, StrictMath.PI / 2.0);
    Arguments.requirePositive("density at " + name + " [kg/m^3]", densityKgPerM3);
    Arguments.requirePositive("time constant of " + name, timeConstantS);
    Arguments.requireInside("part ahead of the direction of " + name, direction.x(), -1e-6, 1e-6);
  }

  /** {@inheritDoc} The deflection [rad]. */
  @Override
  public double level(double command) {
    return travelRad * command;
  }

  /** {@inheritDoc} The servo's power is neglected. */
  @Override
  public OptionalDouble powerW(double level) {
    return OptionalDouble.of(0.0);
  }

  @Override
  public void act(double level, double u, double v, double w, double[] force) {
    double across = v * direction.y() + w * direction.z();
    double pressure = 0.5 * densityKgPerM3 * (u * u + across * across) * areaM2 * liftSlope;
    VesselActuator.push(pressure * level, direction, place, force);
    force[0] -= pressure * level * level;
  }
}
