package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * However the target jumps and time passes: no change is faster than the limit, and none too far.
 */
class SlewLimitProperties {
  private static final double ROUNDING = 1.0e-9;

  /** A target, and the time that passes before it [µs]; clocks of devices may stand or go back. */
  record Step(double target, long micros) {}

  @Provide
  Arbitrary<List<Step>> steps() {
    Arbitrary<Double> targets =
        Arbitraries.oneOf(
            Arbitraries.doubles().between(-120.0, 120.0),
            Arbitraries.of(Double.NaN, 1.0e9, -100.0));
    return Combinators.combine(targets, Arbitraries.longs().between(-1_000, 500_000))
        .as(Step::new)
        .list()
        .ofMaxSize(40);
  }

  @Property
  void towards_anySteps_changesNoFasterThanTheLimit(
      @ForAll("steps") List<Step> steps, @ForAll @DoubleRange(min = 1, max = 1000) double limit) {
    SlewLimit slew = new SlewLimit(limit);
    long now = 0;
    double before = slew.towards(0.0, now);
    for (Step step : steps) {
      now += step.micros();
      double after = slew.towards(step.target(), now);
      double most = limit * Math.max(0.0, Clock.seconds(step.micros()));
      assertThat(Math.abs(after - before)).isLessThanOrEqualTo(most + ROUNDING);
      assertThat(after).isBetween(-100.0, 100.0);
      before = after;
    }
  }

  @Property
  void towards_longEnough_reachesTheTarget(
      @ForAll @DoubleRange(min = -100, max = 100) double target,
      @ForAll @DoubleRange(min = 1, max = 1000) double limit) {
    SlewLimit slew = new SlewLimit(limit);
    slew.towards(target, 0);
    assertThat(slew.towards(target, Clock.micros(100.0 / limit) + 1)).isEqualTo(target);
  }

  @Example
  void towards_unlimited_followsAtOnce() {
    assertThat(new SlewLimit(Double.POSITIVE_INFINITY).towards(-70.0, 0)).isEqualTo(-70.0);
  }

  @Example
  void constructor_notPositive_isRefused() {
    assertThatThrownBy(() -> new SlewLimit(0.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("0.0");
    assertThatThrownBy(() -> new SlewLimit(Double.NaN)).isInstanceOf(BadInputException.class);
  }
}
