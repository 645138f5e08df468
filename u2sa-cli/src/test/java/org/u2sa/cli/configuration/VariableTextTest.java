package org.u2sa.cli.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.contract.ConfigurationVariable;

class VariableTextTest {
  private static final ConfigurationVariable ANGLE =
      new ConfigurationVariable().name("BANK LIMIT").variableType("double").unit("rad");

  @ParameterizedTest
  @ValueSource(strings = {"0.3", "3", "-0.25", ".5", "1e5", "1.5E-15", "2.", "", "much", "NaN"})
  void valueFor_noUnit_isLeftAsItIs(String value) {
    assertThat(VariableText.parse("BANK LIMIT=" + value).valueFor(ANGLE, "Control"))
        .isEqualTo(value);
  }

  @ParameterizedTest
  @CsvSource({
    "0.3 rad, 0.3",
    "1e-1rad, 1e-1",
    "180 deg, 3.141592653589793",
    "18e1°, 3.141592653589793"
  })
  void valueFor_unit_isConvertedToTheDeclaredOne(String value, String expected) {
    assertThat(VariableText.parse("BANK LIMIT=" + value).valueFor(ANGLE, "Control"))
        .isEqualTo(expected);
  }

  @Test
  void valueFor_unitThatIsNone_isRefusedByName() {
    VariableText text = VariableText.parse("BANK LIMIT=3 m");

    assertThatThrownBy(() -> text.valueFor(ANGLE, "Control"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("Control, variable \"BANK LIMIT\"");
  }
}
