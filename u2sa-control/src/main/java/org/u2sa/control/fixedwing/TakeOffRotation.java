package org.u2sa.control.fixedwing;

/**
 * Rotation speed and pitch. In wind the speed is raised by a share of the wind speed, for gusts; as
 * lift grows with speed squared, less pitch then gives the same lift, leaving more margin for
 * upward gusts.
 */
final class TakeOffRotation {
  private final AutopilotVariables tuning;
  private final WindEstimate wind;

  TakeOffRotation(AutopilotVariables tuning, WindEstimate wind) {
    this.tuning = tuning;
    this.wind = wind;
  }

  /** Calibrated airspeed at which rotation starts [m/s]. */
  double speedMps() {
    return AutopilotVariables.KNOT_MPS * tuning.takeOff().rotationSpeed()
        + tuning.guidance().gustShare() * wind.speedMps();
  }

  /** Pitch to which the nose is raised [rad]. */
  double pitchRad() {
    double slower = AutopilotVariables.KNOT_MPS * tuning.takeOff().rotationSpeed() / speedMps();
    return Math.toRadians(tuning.climbOut().rotationPitch()) * slower * slower;
  }
}
