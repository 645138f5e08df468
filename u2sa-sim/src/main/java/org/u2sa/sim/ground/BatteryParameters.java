package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * A battery: an ideal voltage that falls evenly with the charge, behind a resistance.
 *
 * @param fullV without load when full [V]
 * @param emptyV without load when empty [V]
 * @param resistanceOhm inside, with the wires to the motor controllers [Ω]
 * @param capacityAh [A h]
 * @param idleA drawn by the electronics all the time [A]
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
   * A sealed lead-acid block of 12 V, 7 A h as Yuasa's NP7-12: 23 mΩ by its data sheet, 20 mΩ of
   * wires and terminals; 12.8 V full, 11.7 V empty, as usual for lead-acid at rest.
   */
  public static BatteryParameters leadAcid7Ah() {
    return new BatteryParameters(12.8, 11.7, 0.043, 7.0, 0.5);
  }

  /** Three lithium-polymer cells of 5 A h: 4.2 V full and 3.5 V empty each, about 6 mΩ each. */
  public static BatteryParameters lipo3s() {
    return new BatteryParameters(12.6, 10.5, 0.03, 5.0, 0.3);
  }
}
