package org.u2sa.drivers.rc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.u2sa.drivers.rc.RcSwitch.Position.AUTOMATIC;
import static org.u2sa.drivers.rc.RcSwitch.Position.LOST;
import static org.u2sa.drivers.rc.RcSwitch.Position.MANUAL;

import java.util.Map;
import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;

/** Manual unless the radio surely says otherwise. */
class RcSwitchTest {
  private static final long FRAME_MICROS = 20_000; // 50 pulses a second

  private final RcSwitch rcSwitch =
      RcSwitchVariables.read(XmlConfiguration.inMemory("the test", Map.of()));
  private long nowMicros;

  private RcSwitch.Position after(double... pulsesUs) {
    for (double us : pulsesUs) {
      nowMicros += FRAME_MICROS;
      rcSwitch.accept(us * 1.0e-6, nowMicros);
    }
    return rcSwitch.position(nowMicros);
  }

  @Test
  void position_noPulseYet_isLost() {
    assertThat(rcSwitch.position(0)).isEqualTo(LOST);
  }

  @Test
  void accept_longPulses_areAutomaticOnlyInARow() {
    assertThat(after(1900, 1900)).isEqualTo(MANUAL);
    assertThat(after(1200, 1900, 1900)).isEqualTo(MANUAL);
    assertThat(after(1900)).isEqualTo(AUTOMATIC);
  }

  @Test
  void accept_oneShortPulse_isManualAtOnce() {
    after(1900, 1900, 1900);
    assertThat(after(1200)).isEqualTo(MANUAL);
  }

  @Test
  void accept_betweenTheThresholds_staysWhereItWas() {
    assertThat(after(1650, 1650, 1650)).isEqualTo(MANUAL);
    assertThat(after(1750, 1750, 1750, 1650, 1605)).isEqualTo(AUTOMATIC);
    assertThat(after(1595)).isEqualTo(MANUAL);
    assertThat(after(1695, 1695, 1695, 1695)).isEqualTo(MANUAL);
  }

  @Test
  void accept_pulseThatNoReceiverGives_isLostAtOnceAndNeedsConfirmingAgain() {
    after(1900, 1900, 1900);
    assertThat(after(2900)).isEqualTo(LOST);
    assertThat(after(1900, 1900)).isEqualTo(MANUAL);
    assertThat(after(1900)).isEqualTo(AUTOMATIC);
    assertThat(after(Double.NaN)).isEqualTo(LOST);
    assertThat(after(1900, 1900, 1900, 0.0)).isEqualTo(LOST);
  }

  @Test
  void position_noPulseForTheTimeout_isLost() {
    after(1900, 1900, 1900);
    assertThat(rcSwitch.position(nowMicros + 250_000)).isEqualTo(AUTOMATIC);
    assertThat(rcSwitch.position(nowMicros + 250_001)).isEqualTo(LOST);
    nowMicros += 1_000_000;
    assertThat(after(1900, 1900)).as("not automatic before it is confirmed").isEqualTo(MANUAL);
  }

  @Test
  void constructor_thresholdOutsideTheReceiversRange_isRefused() {
    assertThatThrownBy(() -> new RcSwitch(RcChannel.STANDARD, 2400.0, 100.0, 3, 0.25))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("2400.0");
    assertThatThrownBy(() -> new RcSwitch(RcChannel.STANDARD, 1700.0, 100.0, 0, 0.25))
        .isInstanceOf(BadInputException.class);
    assertThatThrownBy(() -> new RcSwitch(RcChannel.STANDARD, 1700.0, 100.0, 3, 0.0))
        .isInstanceOf(BadInputException.class);
  }

  @Test
  void percentage_stickPositions_areShares() {
    assertThat(RcChannel.STANDARD.percentage(0.00125).getAsDouble())
        .isCloseTo(-50.0, within(1.0e-6));
    assertThat(RcChannel.STANDARD.percentage(0.0021).getAsDouble()).isEqualTo(100.0);
    assertThat(RcChannel.STANDARD.percentage(0.0023)).isEqualTo(OptionalDouble.empty());
    assertThat(RcChannel.STANDARD.percentage(Double.NaN)).isEqualTo(OptionalDouble.empty());
  }

  @Property
  void percentage_anyPulse_isWithinTheEndsOrEmpty(
      @ForAll @DoubleRange(min = -0.01, max = 0.03) double pulseS) {
    OptionalDouble percentage = RcChannel.STANDARD.percentage(pulseS);
    assertThat(percentage.isPresent()).isEqualTo(RcChannel.STANDARD.isValid(pulseS));
    percentage.ifPresent(percent -> assertThat(percent).isBetween(-100.0, 100.0));
  }
}
