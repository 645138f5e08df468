package org.u2sa.sim.aircraft;

/**
 * Fixed-pitch propeller of 75 in diameter and 57 in pitch (McCauley 1C160/DTM7557, Cessna 172P
 * handbook, section 1). Coefficients over advance ratio: two-blade 5868-9, Clark Y, of NACA TR-640
 * (Hartman and Biermann 1938) at the blade angle of this pitch, 18° at 0.75 R, with thrust reduced
 * for the fuselage behind it, most at low advance ratios, to match the handbook's static rpm,
 * take-off, climb and cruise.
 */
final class Propeller {
  static final double DIAMETER_M = 1.905;
  static final double DISC_M2 = Math.PI * DIAMETER_M * DIAMETER_M / 4.0;

  /** Moment of inertia of propeller, crankshaft and flywheel [kg m²]. */
  static final double INERTIA_KG_M2 = 2.0;

  private static final double LAST_J =
      2.0; // beyond it the blades act as a plate in the flow: forces scale with V²
  private static final Table THRUST =
      new Table(
          0.0, 0.080, 0.1, 0.0815, 0.2, 0.082, 0.3, 0.081, 0.4, 0.0782, 0.5, 0.0735, 0.6, 0.065,
          0.7, 0.052, 0.8, 0.0355, 0.9, 0.0165, 1.0, -0.003, 1.1, -0.022, 1.2, -0.038, 1.5, -0.065,
          LAST_J, -0.060);
  private static final Table POWER =
      new Table(
          0.0, 0.0574, 0.1, 0.0575, 0.2, 0.0573, 0.3, 0.0568, 0.4, 0.0558, 0.5, 0.0540, 0.6, 0.0505,
          0.7, 0.0450, 0.8, 0.0365, 0.9, 0.0245, 1.0, 0.010, 1.1, -0.006, 1.2, -0.022, 1.5, -0.050,
          LAST_J, -0.040);

  private double thrustN;
  private double torqueNm;

  /**
   * @param speedRadPerS shaft speed, at least 0
   * @param axialMps axial inflow from ahead; flow from behind is treated as still air
   */
  void compute(double speedRadPerS, double axialMps, double densityKgPerM3) {
    double n = speedRadPerS / (2.0 * Math.PI);
    double v = Math.max(0.0, axialMps);
    double tip = n * DIAMETER_M;
    double d2 = DIAMETER_M * DIAMETER_M;
    boolean stopped = v >= LAST_J * tip;
    double j = stopped ? LAST_J : v / tip;
    double speed2 = stopped ? v * v / (LAST_J * LAST_J) : tip * tip; // (nD)²
    double force = densityKgPerM3 * speed2 * d2;
    thrustN = force * THRUST.at(j);
    torqueNm = force * DIAMETER_M * POWER.at(j) / (2.0 * Math.PI);
  }

  /** Thrust [N], negative when windmilling. */
  double thrustN() {
    return thrustN;
  }

  /** Torque absorbed from the engine [N m], negative when windmilling. */
  double torqueNm() {
    return torqueNm;
  }
}
