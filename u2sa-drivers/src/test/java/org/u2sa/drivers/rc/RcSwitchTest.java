package org.u2sa.drivers.rc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.drivers.rc.RcSwitch.Position.AUTOMATIC;
import static org.u2sa.drivers.rc.RcSwitch.Position.LOST;
import static org.u2sa.drivers.rc.RcSwitch.Position.MANUAL;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;

/** Automatic and manual are confirmed; neither survives the loss of the receiver. */
class RcSwitchTest {
  private static final long FRAME_MICROS = 20_000; // 50 pulses a second

  private static final RcSwitch.Variables TUNING =
      XmlConfiguration.inMemory("the test", Map.of()).settings(RcSwitch.Variables.class).get();

  private RcSwitch rcSwitch = new RcSwitch(TUNING);
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
    assertThat(after(1900, 1900)).isEqualTo(LOST);
    assertThat(after(1200, 1900, 1900)).isEqualTo(MANUAL);
    assertThat(after(1900)).isEqualTo(AUTOMATIC);
  }

  @Test
  void accept_shortPulsesThatNeedConfirming_areManualOnlyInARow() {
    rcSwitch = new RcSwitch(TUNING, 3);
    after(1900, 1900, 1900);
    assertThat(after(1200, 1200, 1900, 1200, 1200)).isEqualTo(AUTOMATIC);
    assertThat(after(1200)).isEqualTo(MANUAL);
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
    assertThat(after(1900, 1900)).isEqualTo(LOST);
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
    assertThat(after(1900, 1900)).as("not automatic before it is confirmed").isEqualTo(LOST);
    nowMicros += 1_000_000;
    assertThat(after(1900, 1900)).as("the silence interrupts the row").isEqualTo(LOST);
  }
}
