package org.u2sa.estimation;

import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Converts an estimate to a state message: in GLOBAL if the geodetic position is known, else in
 * LOCAL_NED. Unknown fields are absent; present ones have standard deviations.
 */
public final class EstimateWriter {
  private static final double VERTICAL = 0.02; // cos θ near vertical pitch

  private EstimateWriter() {}

  /** Creates the message, without a sensor name. */
  public static StateInformation write(Estimate e) {
    StateInformation state =
        new StateInformation()
            .referenceFrame(e.isOnEarth() ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_NED);
    state.timestamp(e.micros());
    writePosition(e, state);
    writeAttitude(e, state);
    if (e.hasFlow() && e.hasHeading()) {
      writeFluid(e, state);
    }
    return state;
  }

  private static void writePosition(Estimate e, StateInformation to) {
    boolean isGlobal = e.isOnEarth();
    if (e.hasPosition()) {
      to.x(isGlobal ? e.longitudeDeg() : e.localM(0)).y(isGlobal ? e.latitudeDeg() : e.localM(1));
      to.xSigma(e.positionSigmaM(isGlobal ? 1 : 0)).ySigma(e.positionSigmaM(isGlobal ? 0 : 1));
    }
    if (e.hasAltitude()) {
      to.z(isGlobal ? e.altitudeM() : -e.altitudeM()).zSigma(e.positionSigmaM(2));
    }
    int first = isGlobal ? 1 : 0;
    to.xDot(e.velocityMps(first)).yDot(e.velocityMps(1 - first));
    to.xDotSigma(e.velocitySigmaMps(first)).yDotSigma(e.velocitySigmaMps(1 - first));
    double down = e.velocityMps(2);
    to.zDot(isGlobal ? -down : down).zDotSigma(e.velocitySigmaMps(2));
    if (e.isStrapdown()) {
      to.xDoubleDot(e.accelerationMps2(first)).yDoubleDot(e.accelerationMps2(1 - first));
      to.zDoubleDot((isGlobal ? -1.0 : 1.0) * e.accelerationMps2(2));
    }
  }

  private static void writeAttitude(Estimate e, StateInformation to) {
    if (e.hasTilt()) {
      to.phi(e.phi()).phiSigma(e.attitudeSigma(0));
      to.theta(e.theta()).thetaSigma(e.attitudeSigma(1));
    }
    if (e.hasHeading()) {
      to.psi(e.psi()).psiSigma(e.attitudeSigma(2));
    }
    if (Math.cos(e.theta()) < VERTICAL) {
      return;
    }
    Point rates =
        new Attitude(e.phi(), e.theta(), e.psi())
            .eulerRates(Point.of(e.bodyRate(0), e.bodyRate(1), e.bodyRate(2)));
    if (e.hasTilt()) {
      to.phiDot(rates.x()).phiDotSigma(e.bodyRateSigma(0));
      to.thetaDot(rates.y()).thetaDotSigma(e.bodyRateSigma(1));
    }
    to.psiDot(rates.z()).psiDotSigma(e.bodyRateSigma(2));
  }

  private static void writeFluid(Estimate e, StateInformation to) {
    double[] speeds = new double[3];
    double[] sigmas = new double[3];
    e.fluid(speeds, sigmas);
    for (int i = 0; i < 3; i++) {
      double left = i == 1 ? -speeds[i] : speeds[i]; // BODY: y to the left
      to.number(StateField.values()[StateField.FLUID_X_DOT.ordinal() + i], left);
      to.number(StateField.values()[StateField.FLUID_X_DOT_SIGMA.ordinal() + i], sigmas[i]);
    }
  }
}
