package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Derivatives measured back from forces and moments, at no angle of attack, per radian. */
class AerodynamicsTest {
  private static final double SPEED = 60.0;
  private static final double QS = 0.5 * 1.225 * SPEED * SPEED * 16.17;
  private static final double SPAN = 10.97;
  private static final double CHORD = 1.494;
  private static final double STEP = 1e-4;

  // Roskam, part I, appendix B, airplane A, as documented for the Cessna 172; rudder positive to
  // the right
  @ParameterizedTest
  @CsvSource({
    "beta, side, -0.31",
    "beta, roll, -0.089",
    "beta, yaw, 0.065",
    "p, side, -0.037",
    "p, roll, -0.47",
    "p, yaw, -0.030",
    "r, side, 0.21",
    "r, roll, 0.096",
    "r, yaw, -0.099",
    "q, lift, 3.9",
    "q, pitch, -12.4",
    "aileron, roll, 0.178",
    "aileron, yaw, -0.053",
    "rudder, side, -0.187",
    "rudder, roll, -0.0147",
    "rudder, yaw, 0.0657",
    "elevator, lift, 0.43",
    "elevator, pitch, -1.28",
    "alpha, lift, 4.6",
    "alpha, pitch, -0.89"
  })
  void compute_smallChange_hasTheBooksDerivative(String cause, String effect, double book) {
    double derivative =
        (effect(effect, at(cause, STEP)) - effect(effect, at(cause, -STEP))) / (2 * STEP);
    assertThat(derivative).isCloseTo(book, within(0.04 * Math.abs(book) + 0.001));
  }

  @Test
  void compute_dragPolar_isTheOneOfTheSkyhawk() {
    // least drag over lift at CL = √(CD0 / k): 1 / (2 √(CD0 k)) = 11.6
    double best = 0.0;
    for (double alpha = -0.02; alpha < 0.2; alpha += 0.001) {
      Aerodynamics aero = state(0.0, alpha, 0, 0, 0, 0, 0, 0);
      double lift = aero.forceX * Math.sin(alpha) - aero.forceZ * Math.cos(alpha);
      double drag = -aero.forceX * Math.cos(alpha) - aero.forceZ * Math.sin(alpha);
      best = Math.max(best, lift / drag);
    }
    assertThat(best).isCloseTo(11.6, within(0.1));
  }

  @Test
  void compute_nearTheGround_hasLessInducedDrag() {
    Aerodynamics aero = new Aerodynamics();
    aero.set(ControlInputs.neutral(), 0.0);
    aero.compute(SPEED, 0, 6.0, 0, 0, 0, 1.225, 0, 100.0);
    double high = aero.forceX;
    aero.compute(SPEED, 0, 6.0, 0, 0, 0, 1.225, 0, 1.25);
    assertThat(aero.forceX).isGreaterThan(high + 100.0);
  }

  @Test
  void compute_slipstreamStanding_letsTheElevatorWork() {
    Aerodynamics aero = new Aerodynamics();
    aero.set(ControlInputs.neutral().withSurfaces(0.0, -1.0, 0.0), 0.0);
    aero.compute(0, 0, 0, 0, 0, 0, 1.225, 150.0, 1.25);
    assertThat(aero.momentY).isGreaterThan(500.0);
  }

  private static Aerodynamics at(String cause, double x) {
    double perSpan = 2.0 * SPEED / SPAN;
    return switch (cause) {
      case "alpha" -> state(0, x, 0, 0, 0, 0, 0, 0);
      case "beta" -> state(x, 0, 0, 0, 0, 0, 0, 0);
      case "p" -> state(0, 0, x * perSpan, 0, 0, 0, 0, 0);
      case "q" -> state(0, 0, 0, x * 2.0 * SPEED / CHORD, 0, 0, 0, 0);
      case "r" -> state(0, 0, 0, 0, x * perSpan, 0, 0, 0);
      case "aileron" -> state(0, 0, 0, 0, 0, x / Math.toRadians(17.5), 0, 0);
      case "elevator" -> state(0, 0, 0, 0, 0, 0, x / Math.toRadians(x < 0 ? 28.0 : 23.0), 0);
      case "rudder" -> state(0, 0, 0, 0, 0, 0, 0, x / Math.toRadians(16.0));
      default -> throw new IllegalArgumentException(cause);
    };
  }

  private static Aerodynamics state(
      double beta,
      double alpha,
      double p,
      double q,
      double r,
      double aileron,
      double elevator,
      double rudder) {
    Aerodynamics aero = new Aerodynamics();
    aero.set(ControlInputs.neutral().withSurfaces(aileron, elevator, rudder), 0.0);
    aero.compute(
        SPEED * Math.cos(alpha) * Math.cos(beta),
        SPEED * Math.sin(beta),
        SPEED * Math.sin(alpha) * Math.cos(beta),
        p,
        q,
        r,
        1.225,
        0.0,
        1_000.0);
    return aero;
  }

  private static double effect(String effect, Aerodynamics aero) {
    return switch (effect) {
      case "side" -> aero.forceY / QS;
      case "lift" -> -aero.forceZ / QS;
      case "roll" -> aero.momentX / QS / SPAN;
      case "pitch" -> aero.momentY / QS / CHORD;
      case "yaw" -> aero.momentZ / QS / SPAN;
      default -> throw new IllegalArgumentException(effect);
    };
  }
}
