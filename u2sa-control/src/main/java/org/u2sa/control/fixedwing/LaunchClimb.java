package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;

/**
 * First climb of an aeroplane that is launched by hand or catapult: until it is clear of the
 * ground, height comes before speed, and bank is limited. Its launcher is where it was last seen at
 * rest; one first seen in flight is clear.
 */
final class LaunchClimb {
  private static final double AT_REST_MPS = 2.0; // over ground
  private static final double CLEAR_M = 20.0; // above the launcher
  private static final double BANK_AT_LAUNCHER_RAD = Math.toRadians(5.0);

  private double launcherM; // altitude
  private double share = 1.0; // of the climb

  /**
   * @param stallMps calibrated airspeed below which it does not fly
   */
  void see(FlightState state, double stallMps) {
    boolean atRest =
        state.groundSpeedMps() < AT_REST_MPS && state.calibratedAirspeedMps() < stallMps;
    if (atRest) {
      launcherM = state.altitudeM();
    }
    if (atRest || isUnderWay()) {
      share = Limit.within(0.0, (state.altitudeM() - launcherM) / CLEAR_M, 1.0);
    }
  }

  /** Whether the aeroplane waits on its launcher or is not clear of the ground yet. */
  boolean isUnderWay() {
    return share < 1.0;
  }

  /**
   * Bank limit [rad], which rises with the height above the launcher.
   *
   * @param usualRad limit in flight
   */
  double bankLimitRad(double usualRad) {
    double least = Math.min(usualRad, BANK_AT_LAUNCHER_RAD);
    return least + share * (usualRad - least);
  }

  void transfer(Transfer state) {
    launcherM = state.number("LAUNCHER ALTITUDE", launcherM);
    share = state.number("SHARE OF LAUNCH CLIMB", share, 1.0);
  }
}
