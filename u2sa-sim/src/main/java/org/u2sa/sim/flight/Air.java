package org.u2sa.sim.flight;

import org.u2sa.sim.atmosphere.StandardAtmosphere;

/** The air around an aircraft, and the aircraft's motion through it. */
public final class Air {
  /** Still air at the aircraft's altitude. */
  StandardAtmosphere.Air standard = StandardAtmosphere.at(0.0);

  /** Height of the centre of gravity above ground [m]. */
  double heightM;

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

  /** Still air at the aircraft's altitude. */
  public StandardAtmosphere.Air standard() {
    return standard;
  }

  /** Height of the centre of gravity above ground [m]. */
  public double heightM() {
    return heightM;
  }

  /** Velocity through the air, forward [m/s]. */
  public double u() {
    return u;
  }

  /** Velocity through the air, right [m/s]. */
  public double v() {
    return v;
  }

  /** Velocity through the air, down in body axes [m/s]. */
  public double w() {
    return w;
  }

  /** Angular rate of the gusts about the forward axis [rad/s]. */
  public double gustP() {
    return gustP;
  }

  /** Angular rate of the gusts about the right axis [rad/s]. */
  public double gustQ() {
    return gustQ;
  }

  /** Angular rate of the gusts about the down axis [rad/s]. */
  public double gustR() {
    return gustR;
  }
}
