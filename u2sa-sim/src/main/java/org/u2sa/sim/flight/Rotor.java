package org.u2sa.sim.flight;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * A rotor and its motor, in forward, right, down axes.
 *
 * <p>Thrust k_η ω² + k_h v², with v the speed of the air across the rotor; drag ω k_d v across and
 * ω k_z w along the axis; torque k_m ω² (Svacha, Mohta, Kumar: Improving quadrotor trajectory
 * tracking by compensating for aerodynamic effects, ICUAS 2017).
 *
 * @param name name used in commands
 * @param place hub relative to the centre of gravity [m]
 * @param axis unit vector of the thrust; (0, 0, −1) lifts
 * @param spin 1 if it turns anticlockwise when viewed against the thrust direction, −1 if clockwise
 * @param thrust k_η [N s²]
 * @param torque k_m [N m s²]
 * @param drag k_d [N s²/m]
 * @param inflow k_z [N s²/m]
 * @param lift k_h [N s²/m²]
 * @param maxRadPerS speed at full command [rad/s]
 * @param timeConstantS time constant of the speed [s]
 */
public record Rotor(
    String name,
    Point place,
    Point axis,
    int spin,
    double thrust,
    double torque,
    double drag,
    double inflow,
    double lift,
    double maxRadPerS,
    double timeConstantS) {
  private static final double UNIT = 1e-6;
  private static final double SHORTEST_S = 0.002; // minimum time constant that 400 Hz can integrate

  /**
   * @throws IllegalArgumentException if a value is out of range
   */
  public Rotor {
    Arguments.requireInside(
        "length of the axis of " + name, axis.distance(), 1.0 - UNIT, 1.0 + UNIT);
    if (Math.abs(spin) != 1) {
      throw new IllegalArgumentException("spin of " + name + ": " + spin + " is neither 1 nor -1");
    }
    Arguments.requirePositive("thrust coefficient of " + name, thrust);
    Arguments.requireInside("torque coefficient of " + name, torque, 0.0, 1.0);
    Arguments.requireInside("drag coefficient of " + name, drag, 0.0, 1.0);
    Arguments.requireInside("inflow coefficient of " + name, inflow, 0.0, 1.0);
    Arguments.requireInside("lift coefficient of " + name, lift, 0.0, 1.0);
    Arguments.requirePositive("full speed of " + name + " [rad/s]", maxRadPerS);
    Arguments.requireInside("time constant of " + name + " [s]", timeConstantS, SHORTEST_S, 10.0);
  }

  /** Thrust at full command in still air [N]. */
  public double fullThrustN() {
    return thrust * maxRadPerS * maxRadPerS;
  }
}
