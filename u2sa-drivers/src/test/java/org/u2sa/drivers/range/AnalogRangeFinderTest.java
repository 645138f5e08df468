package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.RangeSensor;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.testkit.ServiceKit;

/** Voltages of data sheets and what they mean. */
class AnalogRangeFinderTest {
  @Test
  void maxBotix_fiveVolts_is9point8MillivoltsAnInch() {
    assertThat(AnalogRangeFinder.maxBotixLvM(0.0098 * 100, 5.0).getAsDouble())
        .isCloseTo(2.54, within(0.01));
    assertThat(AnalogRangeFinder.maxBotixLvM(0.0064 * 100, 3.3).getAsDouble())
        .isCloseTo(2.54, within(0.02));
    assertThat(AnalogRangeFinder.maxBotixLvM(0.0, 5.0).getAsDouble())
        .as("6 inches")
        .isCloseTo(0.1524, within(1.0e-9));
    assertThat(AnalogRangeFinder.maxBotixLvM(255 * 5.0 / 512, 5.0))
        .as("nothing")
        .isEqualTo(OptionalDouble.empty());
    assertThat(AnalogRangeFinder.maxBotixLvM(Double.NaN, 5.0)).isEqualTo(OptionalDouble.empty());
    assertThat(AnalogRangeFinder.maxBotixLvM(-0.1, 5.0)).isEqualTo(OptionalDouble.empty());
  }

  @Test
  void sharp_voltagesOfTheDataSheet_areItsDistances() {
    assertThat(AnalogRangeFinder.sharpM(0.4).getAsDouble()).isCloseTo(0.8, within(1.0e-9));
    assertThat(AnalogRangeFinder.sharpM(2.3).getAsDouble()).isCloseTo(0.1, within(1.0e-9));
    assertThat(AnalogRangeFinder.sharpM(2.4).getAsDouble())
        .as("sensors vary")
        .isCloseTo(0.1, within(1.0e-9));
    assertThat(AnalogRangeFinder.sharpM(0.3))
        .as("nothing in reach")
        .isEqualTo(OptionalDouble.empty());
    assertThat(AnalogRangeFinder.sharpM(3.3))
        .as("no such voltage")
        .isEqualTo(OptionalDouble.empty());
    assertThat(AnalogRangeFinder.sharpM(Double.NaN)).isEqualTo(OptionalDouble.empty());
  }

  @Property
  void sharp_anyTwoVoltages_theLowerIsFarther(
      @ForAll @DoubleRange(min = 0.4, max = 2.3) double one,
      @ForAll @DoubleRange(min = 0.4, max = 2.3) double other) {
    double far = AnalogRangeFinder.sharpM(Math.min(one, other)).getAsDouble();
    double near = AnalogRangeFinder.sharpM(Math.max(one, other)).getAsDouble();
    assertThat(far).isGreaterThanOrEqualTo(near).isBetween(0.099999, 0.800001);
  }

  @Test
  void configuration_namesIt_distancesArePublished(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("in_voltage0_raw"), "400\n");
    try (ServiceKit kit = new ServiceKit()) {
      kit.with("MODEL", "SHARP").with("CONNECTION", file.toString());
      kit.start(RangeSensor::new);
      kit.advance(0.1);
      assertThat(kit.latest(Channels.SENSED_OBJECTS).orElseThrow().x())
          .isCloseTo(0.8, within(1.0e-9));
    }
  }
}
