package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;

/** Whatever is commanded: the pulse stays in its range, is neutral at 0, and grows as it should. */
class PulseWidthProperties {
  private static final double MICRO = 1.0e-6;

  @Provide
  Arbitrary<PulseWidth> widths() {
    Arbitrary<Double> shorts = Arbitraries.doubles().between(500.0, 1400.0);
    Arbitrary<Double> longs = Arbitraries.doubles().between(1600.0, 2500.0);
    Arbitrary<Double> neutrals = Arbitraries.doubles().between(1401.0, 1599.0);
    return Combinators.combine(
            shorts,
            neutrals,
            longs,
            Arbitraries.of(true, false),
            Arbitraries.doubles().between(0.0, 100.0))
        .as(PulseWidth::new);
  }

  @Provide
  Arbitrary<Double> anyNumbers() {
    return Arbitraries.oneOf(
        Arbitraries.doubles().between(-150.0, 150.0),
        Arbitraries.doubles(),
        Arbitraries.of(
            Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -0.0, 100.0, -100.0));
  }

  @Property
  void seconds_anyNumber_isWithinTheEnds(
      @ForAll("widths") PulseWidth width, @ForAll("anyNumbers") double percent) {
    assertThat(width.seconds(percent))
        .isBetween(width.minimumUs() * MICRO, width.maximumUs() * MICRO);
  }

  @Property
  void seconds_zeroAndDeadBand_isNeutral(
      @ForAll("widths") PulseWidth width, @ForAll @DoubleRange(min = -1.0, max = 1.0) double part) {
    assertThat(width.seconds(0.0)).isEqualTo(width.neutralS());
    assertThat(width.seconds(part * width.deadBandPercent())).isEqualTo(width.neutralS());
    assertThat(width.seconds(Double.NaN)).isEqualTo(width.neutralS());
  }

  @Property
  void seconds_twoPercentages_keepTheirOrder(
      @ForAll("widths") PulseWidth width,
      @ForAll @DoubleRange(min = -150.0, max = 150.0) double one,
      @ForAll @DoubleRange(min = -150.0, max = 150.0) double other) {
    double less = width.seconds(Math.min(one, other));
    double more = width.seconds(Math.max(one, other));
    assertThat(width.reversed() ? less - more : more - less).isNotNegative();
  }
}
