package {{package}};

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.messages.StateInformation;
import org.u2sa.testkit.ServiceKit;

class {{Name}}Test {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  @Test
  void step_withinASecond_publishesTenReadings() {
    kit.start({{Name}}::new);
    kit.forget();
    kit.advance(1.0);
    assertThat(kit.published(Channels.SENSED_STATE))
        .hasSize(10)
        .allSatisfy(state -> assertThat(state.z().orElseThrow()).isBetween(90.0, 110.0));
  }

  @Test
  void step_withoutNoise_repeatsToTheBit() {
    kit.with("NOISE", 0.0).start({{Name}}::new);
    StateInformation first = kit.latest(Channels.SENSED_STATE).orElseThrow();
    assertThat(first.z()).hasValue(100.0);
    assertThat(first.sensorName()).isEqualTo("{{Name}}");
  }

  @Test
  void constructor_negativeNoise_isRefused() {
    kit.with("NOISE", -1.0);
    assertThatThrownBy(() -> kit.start({{Name}}::new))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("NOISE");
  }
}
