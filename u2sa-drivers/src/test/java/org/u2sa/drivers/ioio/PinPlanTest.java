package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.testkit.ServiceKit;

/** Wrong wiring is known before anything runs, with the variable's name. */
class PinPlanTest {
  private static final PinPlan DEFAULTS =
      new PinPlan(
          List.of(10, 11),
          50,
          Optional.of(new PinPlan.Uart(6, 7, 9600)),
          Optional.of(new PinPlan.Uart(13, 14, 9600)),
          35,
          40,
          40,
          0);

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private PinPlan plan() {
    return kit.context().configuration().settings(IoioVariables.class).get().plan();
  }

  private static Object value(String text) {
    try {
      return Integer.valueOf(text);
    } catch (NumberFormatException e) {
      return text;
    }
  }

  @Test
  void plan_defaults_isTheOneOfTheDocumentation() {
    assertThat(plan()).isEqualTo(DEFAULTS);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "GPS RX PIN | 8 | pin 8 cannot be pulse measurement or a UART's receive line",
        "GPS RX PIN | 47 | pin 47 is outside 0…46",
        "GPS TX PIN | 9 | pin 9 cannot be PWM or a UART's transmit line",
        "COMPASS RX PIN | 6 | pin 6 is taken by variable \"GPS RX PIN\"",
        "COMPASS TX PIN | 20 | pin 20 cannot be PWM",
        "RC SWITCH PIN | 11 | pin 11 is taken by variable \"ACTUATORS\"",
        "BATTERY PIN | 30 | pin 30 cannot be an analog input",
        "LED PIN | 40 | pin 40 is taken by variable \"BATTERY PIN\"",
        "ACTUATORS | LEFT MOTOR=16 | pin 16 cannot be PWM",
        "ACTUATORS | A=10, B=10 | pin 10 is taken by variable \"ACTUATORS\"",
        "ACTUATORS | A=10, A=11 | each name once",
        "ACTUATORS | A=-1 | pin -1 is none",
        "ACTUATORS | LEFT MOTOR | expected NAME=PIN",
        "ACTUATORS | A=ten | expected NAME=PIN"
      })
  void plan_wrongWiring_namesTheVariable(String variable, String text, String reason) {
    kit.with(variable, value(text));
    assertThatThrownBy(this::plan)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("variable \"" + variable + "\"")
        .hasMessageContaining(reason);
  }

  @Test
  void plan_olderBoard_hasItsPins() {
    kit.with("BOARD", "v1").with("GPS RX PIN", 48);
    assertThat(plan().gps().orElseThrow().receive()).isEqualTo(48);
  }

  @Test
  void plan_withoutBattery_samplesAFreeAnalogInput() {
    kit.with("BATTERY PIN", -1).with("RC SWITCH PIN", 31);
    assertThat(plan().sample()).isEqualTo(32);
    assertThat(plan().battery()).isEqualTo(PinPlan.NONE);
  }

  @Test
  void constructor_withoutConnection_saysWhatIsMissing() {
    assertThatThrownBy(() -> new IoioService(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("variable \"CONNECTION\"");
  }
}
