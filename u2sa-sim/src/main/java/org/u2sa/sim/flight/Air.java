package org.u2sa.sim.flight;

/** The air around an aircraft, and the aircraft's motion through it. */
final class Air {
  /** Density [kg/m³]. */
  double densityKgPerM3;

  /** Velocity of the air, north [m/s]. */
  double windN;

  /** Velocity of the air, east [m/s]. */
  double windE;

  /** Velocity of the air, down [m/s]. */
  double windD;

  /** Angular rate of the gusts about the forward axis [rad/s]. */
  double gustP;

  /** Angular rate of the gusts about the right axis [rad/s]. */
  double gustQ;

  /** Angular rate of the gusts about the down axis [rad/s]. */
  double gustR;

  /** Velocity through the air, forward [m/s]. */
  double u;

  /** Velocity through the air, right [m/s]. */
  double v;

  /** Velocity through the air, down in body axes [m/s]. */
  double w;

  double speedMps() {
    return StrictMath.sqrt(u * u + v * v + w * w);
  }
}
