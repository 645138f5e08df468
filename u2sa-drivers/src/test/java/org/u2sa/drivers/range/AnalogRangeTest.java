package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;

/** Voltages of data sheets and what they mean. */
class AnalogRangeTest {
  private final AnalogRange sharp = AnalogRange.sharpGp2y0a21();

  @Test
  void maxBotix_fiveVolts_is9point8MillivoltsAnInch() {
    AnalogRange sonar = AnalogRange.maxBotixLv(5.0);
    assertThat(sonar.rangeM(0.0098 * 100).getAsDouble()).isCloseTo(2.54, within(0.01));
    assertThat(AnalogRange.maxBotixLv(3.3).rangeM(0.0064 * 100).getAsDouble())
        .isCloseTo(2.54, within(0.02));
    assertThat(sonar.rangeM(0.0).getAsDouble()).as("6 inches").isCloseTo(0.1524, within(1.0e-9));
    assertThat(sonar.rangeM(255 * 5.0 / 512)).as("nothing").isEqualTo(OptionalDouble.empty());
    assertThat(sonar.rangeM(Double.NaN)).isEqualTo(OptionalDouble.empty());
    assertThat(sonar.rangeM(-0.1)).isEqualTo(OptionalDouble.empty());
  }

  @Test
  void sharp_voltagesOfTheDataSheet_areItsDistances() {
    assertThat(sharp.rangeM(0.4).getAsDouble()).isCloseTo(0.8, within(1.0e-9));
    assertThat(sharp.rangeM(2.3).getAsDouble()).isCloseTo(0.1, within(1.0e-9));
    assertThat(sharp.rangeM(2.4).getAsDouble()).as("sensors vary").isEqualTo(0.1);
    assertThat(sharp.rangeM(0.3)).as("nothing in reach").isEqualTo(OptionalDouble.empty());
    assertThat(sharp.rangeM(3.3)).as("no such voltage").isEqualTo(OptionalDouble.empty());
    assertThat(sharp.rangeM(Double.NaN)).isEqualTo(OptionalDouble.empty());
  }

  @Property
  void sharp_anyTwoVoltages_theLowerIsFarther(
      @ForAll @DoubleRange(min = 0.4, max = 2.3) double one,
      @ForAll @DoubleRange(min = 0.4, max = 2.3) double other) {
    double far = sharp.rangeM(Math.min(one, other)).getAsDouble();
    double near = sharp.rangeM(Math.max(one, other)).getAsDouble();
    assertThat(far).isGreaterThanOrEqualTo(near).isBetween(0.099999, 0.800001);
  }

  @Test
  void of_pointsOutOfOrder_areRefused() {
    assertThatThrownBy(() -> VoltageCurve.of(0.1, 2.0, 0.2, 2.1))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("2.1");
    assertThatThrownBy(() -> VoltageCurve.of(0.1, 2.0)).isInstanceOf(BadInputException.class);
    assertThatThrownBy(() -> VoltageCurve.of(0.1, 2.0, 0.2)).isInstanceOf(BadInputException.class);
    assertThatThrownBy(() -> VoltageCurve.of(0.0, 2.0, 0.2, 1.0))
        .isInstanceOf(BadInputException.class);
  }
}
