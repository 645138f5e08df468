package org.u2sa.sim.aircraft;

/**
 * Mass and dimensions of the Cessna 172P at its maximum take-off mass of 2400 lb (Cessna Model 172P
 * Pilot's Operating Handbook, 1982, sections 1 and 6). Moments of inertia: Roskam, Airplane Flight
 * Dynamics and Automatic Flight Controls, part I, appendix B, airplane A. Fuel burn is ignored: an
 * hour of flight uses 2 % of the mass.
 */
final class Airframe {
  static final double MASS_KG = 1_088.6;
  static final double WING_AREA_M2 = 16.17; // 174 sq ft
  static final double SPAN_M = 10.97; // 36 ft
  static final double CHORD_M = 1.494; // 4.9 ft

  private static final double SLUG_FT2 = 1.355818;
  static final double IXX = 948.0 * SLUG_FT2;
  static final double IYY = 1_346.0 * SLUG_FT2;
  static final double IZZ = 1_967.0 * SLUG_FT2;

  static final double ELEVATOR_UP_RAD =
      Math.toRadians(28.0); // travel: type certificate data sheet 3A12
  static final double ELEVATOR_DOWN_RAD = Math.toRadians(23.0);
  static final double AILERON_RAD = Math.toRadians(17.5); // mean of 20° up and 15° down
  static final double RUDDER_RAD = Math.toRadians(16.0);

  private Airframe() {}
}
