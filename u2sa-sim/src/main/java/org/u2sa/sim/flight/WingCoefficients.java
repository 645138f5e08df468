package org.u2sa.sim.flight;

import org.u2sa.sim.motion.Arguments;

/**
 * Aerodynamic coefficients of a fixed-wing aircraft, per radian, as Beard and McLain (Small
 * Unmanned Aircraft, section 4.2) define them: stability axes for lift and drag, body axes for the
 * rest.
 *
 * @param areaM2 wing area [m²]
 * @param spanM wing span [m]
 * @param chordM mean chord [m]
 * @param efficiency Oswald efficiency factor e
 * @param stallRad angle of attack α₀ at which half of the wing has stalled [rad]
 * @param stallSharpness M, the transition rate of the stall
 * @param lift C_L
 * @param parasiticDrag C_Dp
 * @param dragQ C_Dq
 * @param dragElevator C_Dδe
 * @param pitch C_m
 * @param side C_Y
 * @param roll C_ℓ
 * @param yaw C_n
 */
public record WingCoefficients(
    double areaM2,
    double spanM,
    double chordM,
    double efficiency,
    double stallRad,
    double stallSharpness,
    Longitudinal lift,
    double parasiticDrag,
    double dragQ,
    double dragElevator,
    Longitudinal pitch,
    Lateral side,
    Lateral roll,
    Lateral yaw) {

  /**
   * Derivatives of a longitudinal coefficient.
   *
   * @param zero its value at α = 0
   * @param alpha derivative by the angle of attack
   * @param q derivative by the pitch rate, q c / 2V
   * @param elevator derivative by the elevator, trailing edge down positive
   */
  public record Longitudinal(double zero, double alpha, double q, double elevator) {}

  /**
   * Derivatives of a lateral coefficient.
   *
   * @param zero its value at β = 0
   * @param beta derivative by the sideslip
   * @param p derivative by the roll rate, p b / 2V
   * @param r derivative by the yaw rate, r b / 2V
   * @param aileron derivative by the ailerons, rolling right positive
   * @param rudder derivative by the rudder
   */
  public record Lateral(
      double zero, double beta, double p, double r, double aileron, double rudder) {
    double at(double betaRad, double turnP, double turnR, double aileronRad, double rudderRad) {
      return zero
          + beta * betaRad
          + p * turnP
          + r * turnR
          + aileron * aileronRad
          + rudder * rudderRad;
    }
  }

  /**
   * @throws IllegalArgumentException if a dimension is out of range
   */
  public WingCoefficients {
    Arguments.requirePositive("wing area [m²]", areaM2);
    Arguments.requirePositive("wing span [m]", spanM);
    Arguments.requirePositive("chord [m]", chordM);
    Arguments.requireInside("Oswald efficiency", efficiency, 0.1, 1.5);
    Arguments.requireInside("stall angle [rad]", stallRad, 0.05, 1.5);
    Arguments.requireInside("sharpness of the stall", stallSharpness, 1.0, 1_000.0);
  }

  /** Lift coefficient without pitch rate and elevator, stall included (eq. 4.9 and 4.10). */
  double liftAt(double alphaRad) {
    double sin = StrictMath.sin(alphaRad);
    double plate = 2.0 * StrictMath.signum(alphaRad) * sin * sin * StrictMath.cos(alphaRad);
    double stalled = stalled(alphaRad);
    return (1.0 - stalled) * (lift.zero() + lift.alpha() * alphaRad) + stalled * plate;
  }

  /** Drag coefficient without pitch rate and elevator; beyond the stall, that of a flat plate. */
  double dragAt(double alphaRad) {
    double attached = lift.zero() + lift.alpha() * alphaRad;
    double aspect = spanM * spanM / areaM2;
    double induced = attached * attached / (StrictMath.PI * efficiency * aspect);
    double sin = StrictMath.sin(alphaRad);
    double stalled = stalled(alphaRad);
    return parasiticDrag + (1.0 - stalled) * induced + stalled * 2.0 * sin * sin;
  }

  /** Stalled fraction of the wing, 0…1. */
  private double stalled(double alphaRad) {
    double below = StrictMath.exp(-stallSharpness * (alphaRad - stallRad));
    double above = StrictMath.exp(stallSharpness * (alphaRad + stallRad));
    double both = (1.0 + below) * (1.0 + above);
    return Double.isInfinite(both) ? limit(below, above) : (1.0 + below + above) / both;
  }

  private static double limit(double below, double above) {
    // the larger exponential cancels: (1 + x + y) / ((1 + x)(1 + y)) → 1 / (1 + smaller)
    return 1.0 / (1.0 + StrictMath.min(below, above));
  }
}
