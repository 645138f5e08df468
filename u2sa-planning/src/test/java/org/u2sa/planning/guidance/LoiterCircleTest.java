package org.u2sa.planning.guidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** A circle of 100 m on a local plane, flown clockwise, 20 m above the vehicle. */
class LoiterCircleTest {
  private static final LoiterCircle CIRCLE =
      LoiterCircle.signed(
          new Place(false, OptionalDouble.of(0.0), OptionalDouble.of(0.0), OptionalDouble.of(70.0)),
          100.0);

  private static Vehicle at(double north, double east) {
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(north).y(east).z(-50.0);
    state.xDot(0.0).yDot(20.0).psi(Math.toRadians(90.0)).timestamp(0L);
    return Vehicle.of(state).orElseThrow();
  }

  /** The tangent from 200 m away leads 30° past the centre. */
  @ParameterizedTest
  @CsvSource({"-200, 0, -30", "0, -200, 60", "200, 0, 150"})
  void tangentAhead_farAway_isOneLookAheadAlongTheTangent(
      double north, double east, double bearingDeg) {
    Point ahead = CIRCLE.tangentAhead(at(north, east), 50.0, 0.0);

    assertThat(Math.hypot(ahead.x(), ahead.y())).isCloseTo(50.0, within(1e-6));
    assertThat(Math.toDegrees(Math.atan2(ahead.y(), ahead.x())))
        .isCloseTo(bearingDeg, within(1e-6));
    assertThat(ahead.z()).isCloseTo(-20.0, within(1e-6));
  }

  @ParameterizedTest
  @CsvSource({"100, 0", "90, 0", "104, 0", "30, 0"})
  void tangentAhead_onOrInsideTheCircle_isOnTheCircleOneLookAheadAlongIt(
      double north, double east) {
    Point ahead = CIRCLE.tangentAhead(at(north, east), 50.0, 10.0);
    double n = north + ahead.x();
    double e = east + ahead.y();

    assertThat(Math.hypot(n, e)).isCloseTo(110.0, within(1e-6));
    assertThat(Math.atan2(e, n)).isCloseTo(0.5, within(1e-6));
  }

  @Test
  void tangentAhead_tangentNearerThanTheLookAhead_isNoFartherThanTheCircle() {
    Point ahead = CIRCLE.tangentAhead(at(120.0, 0.0), 100.0, 0.0);

    assertThat(Math.hypot(120.0 + ahead.x(), ahead.y())).isCloseTo(100.0, within(1e-6));
  }

  /** It holds where it is: the circle begins on its course, here east. */
  @Test
  void tangentAhead_atTheCentre_leadsOnInsteadOfBack() {
    Point ahead = CIRCLE.tangentAhead(at(0.0, 0.0), 50.0, 0.0);

    assertThat(Math.atan2(ahead.y(), ahead.x())).isCloseTo(0.5 * Math.PI + 0.5, within(1e-6));
  }
}
