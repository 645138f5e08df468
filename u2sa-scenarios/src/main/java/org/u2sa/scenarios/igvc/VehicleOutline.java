package org.u2sa.scenarios.igvc;

import org.u2sa.core.launch.LaunchOptions;

/**
 * Rectangular outline of the vehicle. The reference point is midway between the driven wheels.
 *
 * @param frontM distance from the reference point to the front [m]
 * @param rearM distance from the reference point to the rear [m]
 * @param widthM its width [m]
 */
record VehicleOutline(double frontM, double rearM, double widthM) {
  /** Outline according to config/igvc. */
  static final VehicleOutline USUAL = new VehicleOutline(0.40, 0.20, 0.92);

  static final double NARROWEST_M = 0.5;
  static final double WIDEST_M = 1.2;

  private static final double TYRES_M = 0.06; // half a tyre on each side
  private static final double MAPPED_M = 0.14; // obstacle inflation in the grid, both sides

  /** Copy with a different width [m]. */
  VehicleOutline wide(double newWidthM) {
    return new VehicleOutline(frontM, rearM, newWidthM);
  }

  /** Track width between the driven wheels' centres [m]. */
  double trackM() {
    return widthM - TYRES_M;
  }

  /** Overrides the configuration of planner and control if it differs from their files. */
  void tell(LaunchOptions launch) {
    if (!equals(USUAL)) {
      launch
          .override("PathPlanner", "VEHICLE WIDTH", widthM)
          .override("PathPlanner", "NARROWEST PASSAGE", widthM + MAPPED_M)
          .override("DifferentialPursuitControl", "TRACK", trackM());
    }
  }
}
