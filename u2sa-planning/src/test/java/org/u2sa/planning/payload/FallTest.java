package org.u2sa.planning.payload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class FallTest {
  private static final double G = 9.80665;

  @Test
  void from_withoutDrag_isAParabola() {
    Fall fall =
        Fall.from(
            50.0, Point.of(20.0, -5.0, -2.0), Point.of(9.0, 9.0, 0.0), OptionalDouble.empty());

    double timeS = (2.0 + Math.sqrt(4.0 + 2.0 * G * 50.0)) / G; // −2 t + g t²/2 = 50
    assertThat(fall.timeS()).isCloseTo(timeS, within(0.01));
    assertThat(fall.way().x()).isCloseTo(20.0 * timeS, within(0.2));
    assertThat(fall.way().y()).isCloseTo(-5.0 * timeS, within(0.05));
  }

  /** v = v∞ tanh(g t / v∞), h = v∞²/g ln cosh(g t / v∞). */
  @Test
  void from_restWithDrag_followsTheClosedForm() {
    Fall fall = Fall.from(100.0, Point.ORIGIN, Point.ORIGIN, OptionalDouble.of(15.0));

    double x = G * fall.timeS() / 15.0;
    assertThat(15.0 * 15.0 / G * Math.log(Math.cosh(x))).isCloseTo(100.0, within(0.1));
  }

  @Test
  void from_lightPayloadInWind_isCarriedAlong() {
    Fall fall = Fall.from(100.0, Point.ORIGIN, Point.of(0.0, 5.0, 0.0), OptionalDouble.of(2.0));

    assertThat(fall.way().y()).isCloseTo(5.0 * fall.timeS(), within(2.0));
    assertThat(fall.way().x()).isCloseTo(0.0, within(1e-9));
  }
}
