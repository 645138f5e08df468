package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

class SweepTest {
  @Test
  void of_option_isToldAsOption() {
    Sweep sweep = Sweep.of("payload=0, 5,10");

    assertThat(sweep.values()).containsExactly("0", "5", "10");
    assertThat(sweep.arguments("5")).containsExactly("--payload=5");
  }

  @Test
  void of_variableOfService_isSet() {
    Sweep sweep = Sweep.of("PathPlanner:LOOK AHEAD=0.8,1.2");

    assertThat(sweep.arguments("0.8")).containsExactly("--set", "PathPlanner:LOOK AHEAD=0.8");
  }

  @ParameterizedTest
  @ValueSource(strings = {"payload", "=1,2", "payload=", "payload=1,,2", "payload=1,1", "--a=1"})
  void of_anythingElse_isRefusedWithWhatWasExpected(String text) {
    assertThatThrownBy(() -> Sweep.of(text))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("\"" + text + "\"")
        .hasMessageContaining("NAME=VALUE");
  }

  @Test
  void arguments_valueOfAVehicleFile_areAChange() {
    assertThat(Sweep.of("vehicle:body/mass=20,25").arguments("20"))
        .containsExactly("--change", "body/mass=20");
  }
}
