package org.u2sa.planning.guidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;

class LegProperties {
  private static final double SPAN_M = 10_000.0;

  @Provide
  Arbitrary<Leg> legs() {
    Arbitrary<Double> metres = Arbitraries.doubles().between(-SPAN_M, SPAN_M);
    return Combinators.combine(metres, metres, metres, metres)
        .as(Leg::new)
        .filter(leg -> leg.lengthM() > 1.0);
  }

  @Property
  void alongAndAcross_anyPoint_areItsRectangularCoordinates(
      @ForAll("legs") Leg leg,
      @ForAll @DoubleRange(min = -SPAN_M, max = SPAN_M) double north,
      @ForAll @DoubleRange(min = -SPAN_M, max = SPAN_M) double east) {
    double along = leg.alongM(north, east);
    double across = leg.acrossM(north, east);

    assertThat(Math.hypot(along, across))
        .isCloseTo(Math.hypot(north - leg.startNorthM(), east - leg.startEastM()), within(1.0e-6));
    assertThat(Math.hypot(north - leg.northAtM(along), east - leg.eastAtM(along)))
        .isCloseTo(Math.abs(across), within(1.0e-6));
  }

  @Property
  void endsOfTheLeg_lieOnIt(@ForAll("legs") Leg leg) {
    assertThat(leg.alongM(leg.endNorthM(), leg.endEastM()))
        .isCloseTo(leg.lengthM(), within(1.0e-6));
    assertThat(leg.acrossM(leg.endNorthM(), leg.endEastM())).isCloseTo(0.0, within(1.0e-6));
    assertThat(leg.remainingM(leg.startNorthM(), leg.startEastM()))
        .isCloseTo(leg.lengthM(), within(1.0e-6));
  }

  @Property
  void acrossM_pointToTheRight_isPositive(
      @ForAll("legs") Leg leg, @ForAll @DoubleRange(min = 1.0, max = 100.0) double right) {
    double north = leg.northAtM(5.0) - right * Math.sin(leg.bearingRad());
    double east = leg.eastAtM(5.0) + right * Math.cos(leg.bearingRad());

    assertThat(leg.acrossM(north, east)).isCloseTo(right, within(1.0e-6));
  }

  @Property
  void distanceM_noPointOfTheLegIsNearer(
      @ForAll("legs") Leg leg,
      @ForAll @DoubleRange(min = -SPAN_M, max = SPAN_M) double north,
      @ForAll @DoubleRange(min = -SPAN_M, max = SPAN_M) double east,
      @ForAll @DoubleRange(min = 0.0, max = 1.0) double share) {
    double along = share * leg.lengthM();
    double there = Math.hypot(north - leg.northAtM(along), east - leg.eastAtM(along));

    assertThat(leg.distanceM(north, east)).isLessThanOrEqualTo(there + 1.0e-6);
  }

  @Property
  void turnToRad_wayBack_isHalfATurn(@ForAll("legs") Leg leg) {
    Leg back = new Leg(leg.endNorthM(), leg.endEastM(), leg.startNorthM(), leg.startEastM());

    assertThat(Math.abs(leg.turnToRad(back))).isCloseTo(Math.PI, within(1.0e-9));
    assertThat(leg.turnToRad(leg)).isZero();
  }
}
