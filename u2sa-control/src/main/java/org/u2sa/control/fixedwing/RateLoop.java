package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;

/**
 * Computes a surface deflection from a demanded body rate: feed-forward, proportional and integral
 * terms. Surface effect grows with dynamic pressure and damping with speed, so the proportional and
 * integral terms are scaled by (Vref/V)² and the feed-forward by Vref/V (Stevens and Lewis,
 * Aircraft Control and Simulation, 2nd ed., section 4.4, gain scheduling).
 */
class RateLoop {
  /**
   * @param forward surface per demanded rate [s/rad] at the reference speed
   * @param proportional surface per rate error [s/rad]
   * @param integral surface per integrated rate error [1/rad]; 0 for no integral
   * @param integralLimit limit of the integral part of the surface command, 0…1
   */
  record Gains(double forward, double proportional, double integral, double integralLimit) {}

  private final String name; // key of the integral in a hand-over
  private final Gains gains;
  private double integral;

  RateLoop(String name, Gains gains) {
    this.name = name;
    this.gains = gains;
  }

  /**
   * @param scale Vref/V
   * @return surface, −1…1, positive in the direction of the rate
   */
  final double step(double demanded, double measured, double scale, double dtS) {
    double error = demanded - measured;
    double direct =
        gains.forward() * scale * demanded + gains.proportional() * scale * scale * error;
    double next = integral + gains.integral() * scale * scale * error * dtS;
    double raw = direct + next;
    // Anti-windup: at a stop, the integral may only move away from it.
    boolean deeper = (raw > 1.0 && error > 0.0) || (raw < -1.0 && error < 0.0);
    if (!deeper) {
      integral = Limit.symmetric(next, gains.integralLimit());
    }
    return Limit.symmetric(direct + integral, 1.0);
  }

  /** Restarts with an integral, for bumpless transfer. */
  final void restart(double newIntegral) {
    integral = gains.integral() > 0.0 ? Limit.symmetric(newIntegral, gains.integralLimit()) : 0.0;
  }

  final void transfer(Transfer state) {
    restart(state.number(name, integral, integral));
  }
}
