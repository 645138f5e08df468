package org.u2sa.scenarios.igvc;

import org.u2sa.core.launch.LaunchOptions;

/**
 * The vehicle's rectangle. Its reference point is between its driven wheels.
 *
 * @param frontM from the reference point to its front [m]
 * @param rearM to its rear [m]
 * @param widthM its width [m]
 */
record VehicleOutline(double frontM, double rearM, double widthM) {
  /** What config/igvc says. */
  static final VehicleOutline USUAL = new VehicleOutline(0.40, 0.20, 0.92);

  static final double NARROWEST_M = 0.5;
  static final double WIDEST_M = 1.2;

  private static final double TYRES_M = 0.06; // both halves of the wheels
  private static final double MAPPED_M = 0.14; // that the grid adds to what stands at both sides

  /** The same, of another width [m]. */
  VehicleOutline wide(double newWidthM) {
    return new VehicleOutline(frontM, rearM, newWidthM);
  }

  /** Between the driven wheels' middles [m]. */
  double trackM() {
    return widthM - TYRES_M;
  }

  /** Tells planner and control, if it is not as their files say. */
  void tell(LaunchOptions launch) {
    if (!equals(USUAL)) {
      launch
          .override("PathPlanner", "VEHICLE WIDTH", widthM)
          .override("PathPlanner", "NARROWEST PASSAGE", widthM + MAPPED_M)
          .override("DifferentialPursuitControl", "TRACK", trackM());
    }
  }
}
