package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

class GroundTargetTest {
  private static final Geodetic PLACE = new Geodetic(-81.0478, 29.1885, 0.0);

  private static StateInformation onEarth(double northM, double eastM, double headingDeg) {
    Geodetic place = PLACE.fromNed(Point.of(northM, eastM, 0.0));
    return new StateInformation()
        .x(place.longitudeDeg())
        .y(place.latitudeDeg())
        .psi(Math.toRadians(headingDeg));
  }

  private static Optional<GroundTarget> seen(StateInformation then, StateInformation now) {
    return GroundTarget.seenFrom(
        then, Point.of(10.0, 2.0, 0.0), now, NavigationPoint.at(Point.ORIGIN).turn(0.5));
  }

  @Test
  void seenFrom_vehicleHasGoneAndTurnedMeanwhile_pointStaysWhereItIs() {
    GroundTarget target = seen(onEarth(0.0, 0.0, 0.0), onEarth(4.0, 2.0, 90.0)).orElseThrow();

    assertThat(target.forwardM()).isCloseTo(0.0, within(1.0e-5)); // heading east
    assertThat(target.leftM()).isCloseTo(6.0, within(1.0e-5)); // so north is to the left
    assertThat(target.bearingRad()).isCloseTo(Math.PI / 2.0, within(1.0e-5));
  }

  @Test
  void seenFrom_vehicleHasTurnedMeanwhile_restOfTheTurnIsToTheOtherSide() {
    GroundTarget target = seen(onEarth(0.0, 0.0, 0.0), onEarth(4.0, 2.0, 90.0)).orElseThrow();

    assertThat(target.turnRad().orElseThrow()).isCloseTo(Math.PI / 2.0 - 0.5, within(1.0e-9));
  }

  @Test
  void seenFrom_localFrame_isTheSame() {
    StateInformation then =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(7.0).y(5.0).psi(0.0);
    StateInformation now = then.copy().x(11.0).y(7.0).psi(Math.PI / 2.0); // 4 m north, 2 m east

    GroundTarget target = seen(then, now).orElseThrow();

    assertThat(target.forwardM()).isCloseTo(0.0, within(1.0e-9));
    assertThat(target.leftM()).isCloseTo(6.0, within(1.0e-9));
  }

  @Test
  void seenFrom_statesInDifferentFrames_isNothing() {
    StateInformation local =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(7.0).y(5.0).psi(0.0);

    assertThat(seen(local, onEarth(0.0, 0.0, 0.0))).isEmpty();
    assertThat(seen(onEarth(0.0, 0.0, 0.0), local)).isEmpty();
  }

  @Test
  void seenFrom_positionOrHeadingUnknown_isNothing() {
    StateInformation good = onEarth(0.0, 0.0, 0.0);

    assertThat(seen(good, new StateInformation().psi(0.0))).isEmpty();
    assertThat(seen(good, new StateInformation().x(8.0).y(50.0))).isEmpty();
    assertThat(seen(new StateInformation().psi(0.0), good)).isEmpty();
  }
}
