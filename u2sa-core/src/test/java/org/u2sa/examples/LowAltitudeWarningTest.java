package org.u2sa.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.messages.StateInformation;
import org.u2sa.testkit.ServiceKit;

class LowAltitudeWarningTest {
  private final ServiceKit kit = new ServiceKit().with("LOWEST ALTITUDE", 100.0);

  @AfterEach
  void close() {
    kit.close();
  }

  private void fly(double... altitudesM) {
    for (double altitudeM : altitudesM) {
      kit.publish(Channels.STATE, new StateInformation().z(altitudeM));
    }
  }

  @Test
  void callback_belowLowestAltitude_warnsOnce() {
    kit.start(LowAltitudeWarning::new);
    fly(120.0, 99.0, 98.0, 97.0);
    assertThat(kit.published(AltitudeWarning.CHANNEL)).hasSize(1);
    assertThat(kit.latest(AltitudeWarning.CHANNEL).orElseThrow().altitude()).hasValue(99.0);
    assertThat(kit.log("LowAltitudeWarning")).anyMatch(line -> line.contains("too low at 99.0 m"));
  }

  @Test
  void callback_backAboveMargin_endsWarning() {
    kit.with("MARGIN", 10.0).start(LowAltitudeWarning::new);
    fly(99.0, 105.0, 111.0);
    assertThat(kit.published(AltitudeWarning.CHANNEL))
        .extracting(AltitudeWarning::low)
        .containsExactly(true, false);
  }

  @Test
  void callback_stateWithoutAltitude_saysNothing() {
    kit.start(LowAltitudeWarning::new);
    kit.publish(Channels.STATE, new StateInformation().psi(1.0));
    assertThat(kit.published(AltitudeWarning.CHANNEL)).isEmpty();
  }

  @Test
  void constructor_negativeMargin_isRefused() {
    kit.with("MARGIN", -1.0);
    assertThatThrownBy(() -> kit.start(LowAltitudeWarning::new))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("MARGIN");
  }
}
