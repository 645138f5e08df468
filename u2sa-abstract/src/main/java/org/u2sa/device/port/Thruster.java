package org.u2sa.device.port;

import java.util.OptionalDouble;

/** A propeller with its motor. Off until commanded, and after its own command time-out. */
public interface Thruster extends Device<Thruster.Turning> {
  /**
   * Measurements of the thruster; those not provided are empty.
   *
   * @param rpm propeller speed, positive for forward thrust [1/min]
   * @param thrustN thrust, forward positive [N]
   * @param currentA battery current [A]
   * @param batteryV battery voltage [V]
   */
  record Turning(
      long measuredAtMicros,
      OptionalDouble rpm,
      OptionalDouble thrustN,
      OptionalDouble currentA,
      OptionalDouble batteryV)
      implements Reading {}

  /**
   * Sets the power.
   *
   * @param percent percentage of full power, forward positive [%], −100…100
   */
  void thrust(double percent);

  /** Switches it off immediately, with priority over pending commands. */
  void stop(long nowMicros);

  /** Releases the thruster without changing it, for a successor. */
  void leave();

  /** Switches it off and releases it. */
  @Override
  void close();
}
