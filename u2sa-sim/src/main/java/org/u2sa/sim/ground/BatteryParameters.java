package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Battery model: open-circuit voltage linear in charge, with series resistance.
 *
 * @param fullV open-circuit voltage when full [V]
 * @param emptyV open-circuit voltage when empty [V]
 * @param resistanceOhm internal resistance plus wiring to the motor controllers [Ω]
 * @param capacityAh [A h]
 * @param idleA constant current of the electronics [A]
 */
public record BatteryParameters(
    double fullV, double emptyV, double resistanceOhm, double capacityAh, double idleA) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public BatteryParameters {
    Arguments.requirePositive("empty voltage", emptyV);
    Arguments.requireInside("full voltage", fullV, emptyV, 1_000.0);
    Arguments.requireInside("battery resistance", resistanceOhm, 0.0, 10.0);
    Arguments.requirePositive("capacity", capacityAh);
    Arguments.requireInside("idle current", idleA, 0.0, 100.0);
  }

  /**
   * Sealed lead-acid battery, 12 V, 7 A h, such as Yuasa NP7-12: 23 mΩ (data sheet) plus 20 mΩ
   * wiring; 12.8 V full and 11.7 V empty, typical for lead-acid at rest.
   */
  public static BatteryParameters leadAcid7Ah() {
    return new BatteryParameters(12.8, 11.7, 0.043, 7.0, 0.5);
  }
}
