package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.testkit.ServiceKit;

class ServiceNameTest {
  /** Named by the configuration. */
  private static final class Nameless extends EventDrivenService {
    Nameless(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Nameless");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"Lidar", "LEFT WHEEL", "gps_2", "imu-1.front", "9"})
  void checked_plainName_isTaken(String name) {
    assertThat(ServiceConfiguration.checkedName(name)).isEqualTo(name);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " ", "../x", "a/b", ".hidden", "-x", "a\nb", "a+b", "é"})
  void checked_otherText_isRefused(String name) {
    assertThatThrownBy(() -> ServiceConfiguration.checkedName(name))
        .isInstanceOf(ConfigurationException.class);
  }

  @Test
  void checked_longerThan64_isRefused() {
    assertThat(ServiceConfiguration.checkedName("a".repeat(64))).hasSize(64);
    assertThatThrownBy(() -> ServiceConfiguration.checkedName("a".repeat(65)))
        .isInstanceOf(ConfigurationException.class);
  }

  @Test
  void create_nameThatWouldMoveTheLogFile_isRefusedWithItsValue() {
    try (ServiceKit kit = new ServiceKit().with("SERVICE NAME", "../elsewhere")) {
      assertThatThrownBy(() -> kit.start(Nameless::new))
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining("\"../elsewhere\"")
          .hasMessageContaining("SERVICE NAME");
    }
  }
}
