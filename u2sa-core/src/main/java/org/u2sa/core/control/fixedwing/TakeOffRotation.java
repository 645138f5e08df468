package org.u2sa.core.control.fixedwing;

/**
 * Speed and pitch at which the nose comes up for take-off. In wind it is faster by a share of the
 * wind, for its gusts; as lift goes with the speed's square, less pitch then lifts as much, which
 * leaves the wing more room for upward gusts.
 */
final class TakeOffRotation {
  private final Tuning tuning;
  private final WindEstimate wind;

  TakeOffRotation(Tuning tuning, WindEstimate wind) {
    this.tuning = tuning;
    this.wind = wind;
  }

  /** Calibrated airspeed at which it begins [m/s]. */
  double speedMps() {
    return Tuning.KNOT_MPS * tuning.takeOff().rotationSpeed()
        + tuning.guidance().gustShare() * wind.speedMps();
  }

  /** Pitch to which the nose is raised [rad]. */
  double pitchRad() {
    double slower = Tuning.KNOT_MPS * tuning.takeOff().rotationSpeed() / speedMps();
    return Math.toRadians(tuning.climbOut().rotationPitch()) * slower * slower;
  }
}
