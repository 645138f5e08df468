package org.u2sa.sim.flight;

import org.u2sa.sim.motion.Arguments;

/**
 * A control surface and its servo: a command −1…1 deflects it from one end of its travel to the
 * other. Surfaces that act on two axes, such as elevons, have two shares.
 *
 * @param name name used in commands
 * @param travelRad deflection at full command [rad]
 * @param timeConstantS time constant of the servo [s]
 * @param elevator fraction of the deflection that acts as elevator, trailing edge down positive
 * @param aileron fraction that acts as aileron, rolling right positive
 * @param rudder fraction that acts as rudder, trailing edge left positive
 */
public record ControlSurface(
    String name,
    double travelRad,
    double timeConstantS,
    double elevator,
    double aileron,
    double rudder) {
  /**
   * @throws IllegalArgumentException if a value is out of range
   */
  public ControlSurface {
    Arguments.requireInside("travel of " + name + " [rad]", travelRad, 0.0, StrictMath.PI / 2.0);
    Arguments.requireInside("time constant of " + name + " [s]", timeConstantS, 0.005, 10.0);
    Arguments.requireInside("elevator share of " + name, elevator, -1.0, 1.0);
    Arguments.requireInside("aileron share of " + name, aileron, -1.0, 1.0);
    Arguments.requireInside("rudder share of " + name, rudder, -1.0, 1.0);
  }
}
