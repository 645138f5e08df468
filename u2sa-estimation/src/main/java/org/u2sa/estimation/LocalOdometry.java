package org.u2sa.estimation;

import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Dead-reckoned position and heading in a local frame that starts at the vehicle's first pose and
 * never jumps: body velocities and turn rates are integrated, position and heading corrections are
 * not. It drifts, so only differences over short times are meaningful.
 */
public final class LocalOdometry {
  private static final double LONGEST_STEP_S = 10.0; // longer gaps are not integrated
  private static final double CORRELATION_S = 1.0; // correlation time of speed and turn-rate errors

  private boolean hasBegun;
  private long micros;
  private double north;
  private double east;
  private double down;
  private double psi;
  private double positionVariance;
  private double psiVariance;

  /** Integrates up to an estimate's time. Starts at the first estimate with a heading. */
  public void moveTo(Estimate e) {
    double seconds = (e.micros() - micros) * 1e-6;
    if (!hasBegun || seconds > LONGEST_STEP_S || seconds < 0.0) {
      psi = hasBegun ? psi : e.psi();
      hasBegun = e.hasHeading();
      micros = e.micros();
      return;
    }
    micros = e.micros();
    double turn = e.headingRate() * seconds;
    double cos = StrictMath.cos(e.psi());
    double sin = StrictMath.sin(e.psi());
    double forward = cos * e.velocityMps(0) + sin * e.velocityMps(1);
    double right = cos * e.velocityMps(1) - sin * e.velocityMps(0);
    double middle = psi + turn / 2.0;
    north += seconds * (forward * StrictMath.cos(middle) - right * StrictMath.sin(middle));
    east += seconds * (forward * StrictMath.sin(middle) + right * StrictMath.cos(middle));
    down += seconds * e.velocityMps(2);
    psi = Math.IEEEremainder(psi + turn, 2.0 * Math.PI);
    double speedSigma = Math.max(e.velocitySigmaMps(0), e.velocitySigmaMps(1));
    double sideways = Math.hypot(forward, right) * Math.sqrt(psiVariance);
    positionVariance +=
        seconds * (CORRELATION_S * speedSigma * speedSigma + 2.0 * seconds * sideways * sideways);
    psiVariance += seconds * CORRELATION_S * e.bodyRateSigma(2) * e.bodyRateSigma(2);
  }

  /** Creates the local state, in LOCAL_NED. */
  public StateInformation write(Estimate e) {
    double turned = psi - e.psi();
    double cos = StrictMath.cos(turned);
    double sin = StrictMath.sin(turned);
    double vn = e.velocityMps(0);
    double ve = e.velocityMps(1);
    double sigma = Math.sqrt(positionVariance);
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(north)
            .y(east)
            .z(down)
            .xSigma(sigma)
            .ySigma(sigma)
            .zSigma(sigma)
            .xDot(cos * vn - sin * ve)
            .yDot(sin * vn + cos * ve)
            .zDot(e.velocityMps(2))
            .psi(psi < 0.0 ? psi + 2.0 * Math.PI : psi)
            .psiSigma(Math.sqrt(psiVariance))
            .psiDot(e.headingRate());
    if (e.hasTilt()) {
      state.phi(e.phi()).theta(e.theta());
    }
    state.timestamp(e.micros());
    return state;
  }

  /** Resumes from a previously published local state. */
  public void resume(StateInformation local) {
    hasBegun = true;
    micros = local.timestamp().orElseThrow();
    north = local.x().orElse(0.0);
    east = local.y().orElse(0.0);
    down = local.z().orElse(0.0);
    psi = local.psi().orElse(0.0);
    positionVariance = Math.pow(local.xSigma().orElse(0.0), 2.0);
    psiVariance = Math.pow(local.psiSigma().orElse(0.0), 2.0);
  }
}
