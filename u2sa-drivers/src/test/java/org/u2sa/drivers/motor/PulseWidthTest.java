package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.device.SlewLimit;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;

class PulseWidthTest {
  private static final double NEAR_S = 1.0e-9;

  @Test
  void seconds_standardServo_spansOneToTwoMilliseconds() {
    assertThat(PulseWidth.STANDARD.seconds(-100.0)).isCloseTo(0.001, within(NEAR_S));
    assertThat(PulseWidth.STANDARD.seconds(0.0)).isCloseTo(0.0015, within(NEAR_S));
    assertThat(PulseWidth.STANDARD.seconds(50.0)).isCloseTo(0.00175, within(NEAR_S));
    assertThat(PulseWidth.STANDARD.seconds(100.0)).isCloseTo(0.002, within(NEAR_S));
  }

  @Test
  void seconds_unequalHalvesReversed_exchangesTheEnds() {
    PulseWidth width = new PulseWidth(1100.0, 1500.0, 2100.0, true, 0.0);
    assertThat(width.seconds(100.0)).isCloseTo(0.0011, within(NEAR_S));
    assertThat(width.seconds(-50.0)).isCloseTo(0.0018, within(NEAR_S));
  }

  @Test
  void constructor_neutralBeyondTheEnd_namesAllThree() {
    assertThatThrownBy(() -> new PulseWidth(1000.0, 2500.0, 2000.0, false, 0.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContainingAll("1000.0", "2500.0", "2000.0");
    assertThatThrownBy(() -> new PulseWidth(1000.0, Double.NaN, 2000.0, false, 0.0))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void output_noPercentage_isNeutralAtOnceAndStartsAgainFromThere() {
    PulseOutput output = new PulseOutput(PulseWidth.STANDARD, new SlewLimit(100.0));
    output.seconds(OptionalDouble.of(100.0), 0);
    assertThat(output.seconds(OptionalDouble.of(100.0), 1_000_000))
        .isCloseTo(0.002, within(NEAR_S));
    assertThat(output.seconds(OptionalDouble.empty(), 1_010_000))
        .isEqualTo(PulseWidth.STANDARD.neutralS());
    assertThat(output.seconds(OptionalDouble.of(100.0), 1_110_000))
        .as("10 % after 0.1 s")
        .isCloseTo(0.00155, within(NEAR_S));
  }

  @Test
  void read_variablesOfAnActuator_makeItsOutput() {
    PulseOutput output =
        PulseOutput.configured(
            XmlConfiguration.inMemory(
                "the test",
                Map.of("LEFT MOTOR MAX PULSE", 1900.0, "LEFT MOTOR SLEW LIMIT", 100_000.0)),
            "LEFT MOTOR");
    output.seconds(OptionalDouble.of(100.0), 0);
    assertThat(output.seconds(OptionalDouble.of(100.0), 1_000_000))
        .isCloseTo(0.0019, within(NEAR_S));
  }

  @Test
  void read_pulsesOutOfOrder_namesTheActuator() {
    XmlConfiguration wrong =
        XmlConfiguration.inMemory("the test", Map.of("STEERING NEUTRAL PULSE", 900.0));
    assertThatThrownBy(() -> PulseOutput.configured(wrong, "STEERING"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContainingAll("STEERING NEUTRAL PULSE", "900");
  }
}
