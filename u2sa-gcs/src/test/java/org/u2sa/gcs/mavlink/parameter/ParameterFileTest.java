package org.u2sa.gcs.mavlink.parameter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Parameter files of QGroundControl, Mission Planner and MAVProxy. */
class ParameterFileTest {
  private final ParameterFile file =
      new ParameterFile(
          List.of(
              service("SafetyManager", variable("BRAKING", "double", "0.1").min(0.0).max(5.0)),
              service(
                  "Control",
                  variable("GAIN", "double", "1234567.891"),
                  variable("LIMIT", "int", "-7"),
                  variable("MODE", "string", "B").choices(List.of("A", "B")),
                  variable("FILE", "string", "a.xml"))));

  private static ConfigurationResponse service(String name, ConfigurationVariable... variables) {
    return new ConfigurationResponse().serviceName(name).variables(List.of(variables));
  }

  private static ConfigurationVariable variable(String name, String type, String value) {
    return new ConfigurationVariable().name(name).variableType(type).value(value);
  }

  private List<String> changed(String text) {
    return file.changes("x.parm", text).stream()
        .flatMap(
            each ->
                each.assignments().stream()
                    .map(one -> each.serviceName() + " " + one.variableName() + "=" + one.value()))
        .collect(Collectors.toList());
  }

  @Test
  void parmAndParams_readBack_changeNothing() {
    assertThat(file.parm())
        .isEqualTo("CON_GAIN,1234567.891\nCON_LIMIT,-7\nCON_MODE,1\nSAFM_BRAKING,0.1\n");
    assertThat(file.params()).endsWith("\n1\t1\tCON_MODE\t1\t6\n1\t1\tSAFM_BRAKING\t0.1\t9\n");
    assertThat(changed(file.parm())).isEmpty();
    assertThat(changed(file.params())).isEmpty();
  }

  @Test
  void changes_asStationsWriteThem_areExact() {
    assertThat(changed("1\t1\tSAFM_BRAKING\t0.300000011920928955078\t9\r\n"))
        .as("0.3f as QGroundControl writes it")
        .containsExactly("SafetyManager BRAKING=0.3");
    assertThat(
            changed("CON_GAIN         7654321.123456 # MAVProxy\nCON_LIMIT 3.000000\n\nCON_MODE,0"))
        .containsExactly("Control GAIN=7654321.123456", "Control LIMIT=3", "Control MODE=A");
  }

  @Test
  void changes_wrongLines_areNamedTogether() {
    assertThatThrownBy(
            () ->
                changed(
                    "SAFM_BRAKIN,1\nSAFM_BRAKING,9\nCON_LIMIT,1.5\nCON_MODE,2\nCON_GAIN,NaN\nCON_GAIN,x\n1\t42\tCON_GAIN\t1\t9\njust words here\nCON_LIMIT,1\n"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContainingAll(
            "x.parm, line 1: no parameter \"SAFM_BRAKIN\"",
            "SAFM_BRAKING",
            "line 2: SAFM_BRAKING 9.0: expected 0.0…5.0",
            "line 3: CON_LIMIT 1.5: expected a whole number",
            "line 4: CON_MODE 2: expected 0 = A, 1 = B",
            "line 5: CON_GAIN \"NaN\": expected a finite number",
            "line 6: \"CON_GAIN\" is given twice",
            "line 7: component \"42\": expected 1, the autopilot",
            "line 8: \"just words here\": expected NAME,VALUE",
            "line 9: \"CON_LIMIT\" is given twice");
  }

  @Test
  void changes_numbersThatOnlyJavaHasAndLongLines_areRefusedShortly() {
    for (String value : List.of("0x1p-1", "1d", "1f", "Infinity", "9".repeat(100_000))) {
      assertThatThrownBy(() -> changed("CON_GAIN," + value))
          .isInstanceOf(BadInputException.class)
          .hasMessageContaining("line 1: CON_GAIN \"")
          .satisfies(refused -> assertThat(refused.getMessage()).hasSizeLessThan(400));
    }
  }
}
