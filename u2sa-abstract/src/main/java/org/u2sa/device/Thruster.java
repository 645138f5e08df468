package org.u2sa.device;

import java.util.OptionalDouble;

/**
 * One propeller and its motor. Off until it is told to thrust, and when it has not been told
 * anything for its own time-out.
 */
public interface Thruster extends Device<Thruster.Turning> {
  /**
   * What it measured. What the thruster does not measure is empty.
   *
   * @param rpm of the propeller, positive where it pushes forward [1/min]
   * @param thrustN forward positive [N]
   * @param currentA from its battery [A]
   * @param batteryV voltage of its battery [V]
   */
  record Turning(
      long measuredAtMicros,
      OptionalDouble rpm,
      OptionalDouble thrustN,
      OptionalDouble currentA,
      OptionalDouble batteryV)
      implements Reading {}

  /**
   * Sets what it does from now on.
   *
   * @param percent share of full power, forward positive [%], −100…100
   */
  void thrust(double percent);

  /** Switches it off at once, whatever else is under way. */
  void stop(long nowMicros);

  /** Lets go of the thruster and leaves it as it is, for a successor. */
  void leave();

  /** Switches it off and lets go of it. */
  @Override
  void close();
}
