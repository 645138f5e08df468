package org.u2sa.sim.flight;

import java.util.List;
import java.util.Optional;
import org.u2sa.sim.motion.Arguments;

/** Aerodynamic forces and moments on one aircraft, influenced by its actuators. */
public interface AirLoads {
  /** Names of the actuators; each has one state, its speed or its deflection. */
  List<String> actuators();

  /**
   * Sets the target of an actuator.
   *
   * @param value −1…1, or 0…1 for actuators that turn only one way
   * @throws IllegalArgumentException if it is outside
   */
  void command(int actuator, double value);

  /** Weakens an actuator: remaining fraction of its effect, 0…1. */
  void weaken(int actuator, double share);

  /** Whether the forward drive is commanded to run; a catapult waits for this. */
  boolean isDriven();

  /** Span over which the gusts act [m]. */
  double spanM();

  /**
   * Adds the loads and computes the rates of the actuators' states.
   *
   * @param s state of the aircraft; those of the actuators begin at {@code first}
   * @param rate its derivative
   * @param load force and moment in body axes [N, N m]
   */
  void add(double[] s, double[] rate, int first, Air air, double[] load);

  /**
   * Advances everything that changes in discrete steps: control systems, engines, fuel. Called
   * before each tick.
   *
   * @param s state of the aircraft; its actuators' states may be set
   * @param rate derivative of the state after the last tick
   * @param first as of {@link #add}
   */
  default void tick(double[] s, double[] rate, int first, Air air, double dtS) {
    // nothing does
  }

  /** Mass from the next tick on, if it varies. */
  default Optional<MassProperties> mass() {
    return Optional.empty();
  }

  /**
   * Power drawn by its motors [W].
   *
   * @param s as of {@link #add}
   */
  double powerW(double[] s, int first, Air air);

  /** Remaining effect of an actuator after a failure. */
  static double share(double value) {
    return Arguments.requireInside("share of an actuator's effect", value, 0.0, 1.0);
  }
}
