package org.u2sa.sim.guide;

import org.u2sa.messages.frame.Point;

/**
 * A straight guide and its drive.
 *
 * @param direction unit vector of positive travel: forward, right, down
 * @param lowestM end of travel from the start, at most 0 [m]
 * @param highestM end of travel from the start, at least 0 [m]
 * @param forceN force of the drive at full command [N]
 * @param lagS time constant of the force [s]
 * @param dragNsPerM friction proportional to the speed [N s/m]
 * @param frictionN friction independent of it [N]
 * @param brakeN additional friction while the drive has no signal [N]
 * @param counterweightKg mass that moves up when the carriage moves down [kg]
 */
public record Guide(
    Point direction,
    double lowestM,
    double highestM,
    double forceN,
    double lagS,
    double dragNsPerM,
    double frictionN,
    double brakeN,
    double counterweightKg) {

  /**
   * @throws IllegalArgumentException if the travel is empty
   */
  public Guide {
    if (!(lowestM <= 0.0 && highestM >= 0.0 && lowestM < highestM)) {
      throw new IllegalArgumentException(
          "travel " + lowestM + "…" + highestM + " m: expected a range that contains the start");
    }
  }
}
