package org.u2sa.messages.frame;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class AttitudeProperties {
  private static final double NEAR = 1e-9;

  @Property(tries = 200)
  void nedOf_whatBodyOfMade_isTheVectorAgain(
      @ForAll @DoubleRange(min = -3.0, max = 3.0) double phi,
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double theta,
      @ForAll @DoubleRange(min = 0.0, max = 6.28) double psi,
      @ForAll @DoubleRange(min = -100.0, max = 100.0) double north) {
    Attitude attitude = new Attitude(phi, theta, psi);
    Point ned = Point.of(north, 30.0, -7.0);

    assertThat(attitude.nedOf(attitude.bodyOf(ned)).distanceTo(ned)).isLessThan(NEAR);
    Point rates = attitude.eulerRates(attitude.bodyRates(Point.of(0.1, north / 100.0, 0.3)));
    assertThat(rates.distanceTo(Point.of(0.1, north / 100.0, 0.3))).isLessThan(NEAR);
  }

  @Property(tries = 50)
  void levelOf_anyHeading_isTheBodyOfALevelVehicle(
      @ForAll @DoubleRange(min = 0.0, max = 6.28) double psi) {
    Attitude level = new Attitude(0.0, 0.0, psi);
    Point ned = Point.of(5.0, -3.0, 2.0);

    assertThat(level.levelOf(ned).distanceTo(level.bodyOf(ned))).isCloseTo(0.0, within(NEAR));
  }

  @Property(tries = 1)
  void bodyOf_pointToTheEastOfANorthboundVehicle_liesToItsRight() {
    Point body = new Attitude(0.0, 0.0, 0.0).bodyOf(Point.of(0.0, 4.0, 0.0));

    assertThat(body).isEqualTo(Point.of(0.0, -4.0, 0.0)); // y is to the left
  }
}
