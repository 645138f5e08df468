package org.u2sa.estimation;

import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Extrapolates a measured position and attitude to a later time using the rates measured with them,
 * and increases their standard deviations for the unmeasured motion since.
 *
 * @param velocitySigmaMps assumed standard deviation of a velocity without one [m/s]
 * @param accelerationMps2 unmeasured acceleration, 1 σ [m/s²]
 * @param unknownSpeedMps speed if no velocity is measured, 1 σ [m/s]
 * @param unknownTurnRadPerS turn rate if none is measured, 1 σ [rad/s]
 */
record DeadReckoning(
    double velocitySigmaMps,
    double accelerationMps2,
    double unknownSpeedMps,
    double unknownTurnRadPerS) {
  private static final double FULL_TURN = 2.0 * Math.PI;

  /** Fields of one component of position or attitude: value, rate and their standard deviations. */
  private record Axis(StateField value, StateField rate, StateField sigma, StateField rateSigma) {}

  private static final Axis[] POSITION = {
    new Axis(StateField.X, StateField.X_DOT, StateField.X_SIGMA, StateField.X_DOT_SIGMA),
    new Axis(StateField.Y, StateField.Y_DOT, StateField.Y_SIGMA, StateField.Y_DOT_SIGMA),
    new Axis(StateField.Z, StateField.Z_DOT, StateField.Z_SIGMA, StateField.Z_DOT_SIGMA)
  };
  private static final Axis[] ATTITUDE = {
    new Axis(StateField.PHI, StateField.PHI_DOT, StateField.PHI_SIGMA, StateField.PHI_DOT_SIGMA),
    new Axis(
        StateField.THETA, StateField.THETA_DOT, StateField.THETA_SIGMA, StateField.THETA_DOT_SIGMA),
    new Axis(StateField.PSI, StateField.PSI_DOT, StateField.PSI_SIGMA, StateField.PSI_DOT_SIGMA)
  };

  /** Extrapolates a measurement to the given time; returns it unchanged if it is not older. */
  StateInformation at(long micros, StateInformation measured) {
    double ageS = Clock.seconds(micros - measured.timestamp().orElse(micros));
    if (ageS <= 0.0) {
      return measured;
    }
    StateInformation carried = measured.copy();
    if (measured.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      moveOnEarth(measured, carried, ageS);
    } else if (!measured.referenceFrame().isBody()) {
      move(POSITION, measured, carried, ageS);
    }
    move(ATTITUDE, measured, carried, ageS);
    carried.psi().ifPresent(psi -> carried.psi(turned(psi)));
    for (Axis axis : POSITION) {
      grow(axis, carried, ageS, velocitySigmaMps, unknownSpeedMps, accelerationMps2);
    }
    for (Axis axis : ATTITUDE) {
      grow(axis, carried, ageS, 0.0, unknownTurnRadPerS, 0.0);
    }
    return carried;
  }

  private static void moveOnEarth(StateInformation measured, StateInformation to, double ageS) {
    if (measured.x().isEmpty() || measured.y().isEmpty()) {
      return;
    }
    Geodetic place =
        new Geodetic(
                measured.x().getAsDouble(), measured.y().getAsDouble(), measured.z().orElse(0.0))
            .fromEnu(
                Point.of(
                    ageS * measured.xDot().orElse(0.0),
                    ageS * measured.yDot().orElse(0.0),
                    ageS * measured.zDot().orElse(0.0)));
    to.x(place.longitudeDeg()).y(place.latitudeDeg());
    measured.z().ifPresent(z -> to.z(place.altitudeM()));
  }

  private static void move(
      Axis[] axes, StateInformation measured, StateInformation to, double ageS) {
    for (Axis axis : axes) {
      OptionalDouble value = measured.number(axis.value());
      OptionalDouble rate = measured.number(axis.rate());
      if (value.isPresent() && rate.isPresent()) {
        to.number(axis.value(), value.getAsDouble() + ageS * rate.getAsDouble());
      }
    }
  }

  private static double turned(double angle) {
    double rest = angle % FULL_TURN;
    return rest < 0.0 ? rest + FULL_TURN : rest;
  }

  /** σ² = σ0² + (σ_rate t)² + (a t² / 2)², assuming independent errors. */
  private static void grow(
      Axis axis,
      StateInformation state,
      double ageS,
      double usualRateSigma,
      double unknownRate,
      double acceleration) {
    OptionalDouble sigma = state.number(axis.sigma());
    if (sigma.isEmpty()) {
      return;
    }
    double rate =
        state.number(axis.rate()).isPresent()
            ? state.number(axis.rateSigma()).orElse(usualRateSigma)
            : unknownRate;
    double byRate = Math.hypot(sigma.getAsDouble(), rate * ageS);
    state.number(axis.sigma(), Math.hypot(byRate, acceleration * ageS * ageS / 2.0));
  }
}
