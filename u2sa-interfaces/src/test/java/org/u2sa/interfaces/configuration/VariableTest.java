package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.units.NumberText;
import org.u2sa.messages.contract.ConfigurationVariable;

class VariableTest {
  private static final VariableDeclaration<Double> GAIN =
      VariableDeclaration.number("HEADING GAIN", "%/rad")
          .range(Range.of(0.0, 500.0))
          .ifAbsent(120.0)
          .describedAs("Turns.");

  @Test
  void ifAbsent_outsideRange_isRefusedAtDeclaration() {
    assertThatThrownBy(() -> GAIN.ifAbsent(501.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "variable \"HEADING GAIN\" is declared with a default that it refuses:"
                + " 501 %/rad is outside 0…500 %/rad");
    assertThatThrownBy(() -> GAIN.range(Range.of(0, 1)))
        .hasMessageEndingWith("120 %/rad is outside 0…1 %/rad");
  }

  @Test
  void refusal_eachKindOfRange_readsWell() {
    assertThat(Range.of(0, 60).refusal("95 deg", "deg")).isEqualTo("95 deg is outside 0…60 deg");
    assertThat(Range.positive().refusal("-3 m", "m")).isEqualTo("-3 m is not above 0 m");
    assertThat(Range.nonNegative().refusal("-3", "")).isEqualTo("-3 is not at least 0");
    assertThat(Range.above(0, 1).refusal("2 m", "m"))
        .isEqualTo("2 m is outside 0…1 m (0 itself is also outside)");
  }

  @Test
  void range_ofAText_isRefusedAtDeclaration() {
    assertThatThrownBy(() -> VariableDeclaration.text("A").range(Range.positive()))
        .hasMessage("variable \"A\" is not a number: no range");
  }

  @Test
  void name_empty_isRefused() {
    assertThatThrownBy(() -> VariableDeclaration.flag(" ")).hasMessage("a variable needs a name");
  }

  @Test
  void range_eachKind_containsWhatItSays() {
    assertThat(Range.of(1, 2).contains(1)).isTrue();
    assertThat(Range.of(1, 2).contains(2)).isTrue();
    assertThat(Range.of(1, 2).contains(2.0000001)).isFalse();
    assertThat(Range.positive().contains(0)).isFalse();
    assertThat(Range.positive().contains(Double.MIN_VALUE)).isTrue();
    assertThat(Range.nonNegative().contains(0)).isTrue();
    assertThat(Range.nonNegative().contains(-1e-300)).isFalse();
    assertThat(Range.any().contains(Double.NaN)).isFalse();
    assertThat(Range.any().contains(Double.POSITIVE_INFINITY)).isFalse();
    assertThatThrownBy(() -> Range.of(2, 1)).hasMessage("a range from 2.0 to 1.0 is empty");
    assertThatThrownBy(() -> Range.of(Double.NaN, 1)).isInstanceOf(IllegalArgumentException.class);
    assertThat(
            new Range[] {
              Range.of(0, 500),
              Range.positive(),
              Range.nonNegative(),
              Range.any(),
              Range.of(Double.NEGATIVE_INFINITY, 7),
              Range.of(-1.5, 1e-9)
            })
        .extracting(Range::toString)
        .containsExactly("0…500", "above 0", "at least 0", "any number", "at most 7", "-1.5…1E-9");
  }

  @ParameterizedTest
  @CsvSource({
    "String, STRING",
    "string, STRING",
    "DOUBLE, DOUBLE",
    "int, INTEGER",
    "Integer, INTEGER",
    "Boolean, BOOLEAN",
    "' boolean ', BOOLEAN"
  })
  void named_thesisTypes_inAnyCase(String xmlName, VariableType type) {
    assertThat(VariableType.named(xmlName)).contains(type);
  }

  @Test
  void named_other_isEmpty() {
    assertThat(VariableType.named("float")).isEmpty();
  }

  @Test
  void describe_declaredAndNot_hasAllThatIsKnown() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of("HOST", "localhost"));
    configuration.getVariable(GAIN);

    assertThat(configuration.describe())
        .containsExactly(
            new ConfigurationVariable()
                .name("HOST")
                .variableType("string")
                .value("localhost")
                .unit("")
                .description(""),
            new ConfigurationVariable()
                .name("HEADING GAIN")
                .variableType("double")
                .value("120.0")
                .unit("%/rad")
                .min(0)
                .max(500)
                .description("Turns."));
  }

  @Test
  void getVariable_declaredAgainAfterAChange_keepsTheChange() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of());
    configuration.getVariable(GAIN);
    assertThat(configuration.setVariable("HEADING GAIN", 7)).isTrue();

    assertThat(configuration.getVariable(GAIN.ifAbsent(1.0))).isEqualTo(7.0);
  }

  @Test
  void enumerateFields_list_isTheCallersOwn() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of("HOST", "a"));
    configuration.enumerateFields().clear();

    assertThat(configuration.enumerateFields()).hasSize(1);
  }

  @Test
  void inMemory_valueOfAnotherClass_isRefused() {
    assertThatThrownBy(() -> XmlConfiguration.inMemory("test", Map.of("A", 1L)))
        .hasMessage("test, variable \"A\": 1 is neither Integer, Double, Boolean nor String");
  }

  private static VariableDeclaration<Double> depth() {
    return VariableDeclaration.number("DEPTH", "m")
        .range(Range.of(0, 9))
        .ifAbsent(1.0)
        .describedAs("How deep.");
  }

  @Test
  void declaration_ofEachKind_saysNameTypeAndUnit() {
    assertThat(VariableDeclaration.number("A", "m")).hasToString("variable \"A\" (double, m)");
    assertThat(VariableDeclaration.integer("A")).hasToString("variable \"A\" (int)");
    assertThat(VariableDeclaration.integer("A", "ms")).hasToString("variable \"A\" (int, ms)");
    assertThat(VariableDeclaration.text("A")).hasToString("variable \"A\" (string)");
    assertThat(VariableDeclaration.flag("A")).hasToString("variable \"A\" (boolean)");
  }

  @Test
  void declaration_withAllThatCanBeSaid_keepsIt() {
    VariableDeclaration<Double> depth = depth();

    assertThat(depth.range()).isEqualTo(Range.of(0, 9));
    assertThat(depth.ifAbsent()).contains(1.0);
    assertThat(depth.description()).isEqualTo("How deep.");
    assertThat(depth.choices()).isEmpty();
    assertThat(VariableDeclaration.integer("A").oneOf(1, 3).choices()).containsExactly(1, 3);
    assertThat(VariableDeclaration.integer("A").oneOf(1, 3).choicesText()).isEqualTo("1, 3");
  }

  @Test
  void range_ofOneNumber_holdsThatOne() {
    assertThat(Range.of(2, 2).contains(2)).isTrue();
    assertThatCode(() -> Range.of(-0.5, -0.5)).doesNotThrowAnyException();
  }

  @Test
  void between_openEnd_staysOpenAsLongAsItIsTheSameEnd() {
    assertThat(Range.positive().between(0, 5)).hasToString("above 0…5");
    assertThat(Range.positive().between(1, 5)).isEqualTo(Range.of(1, 5));
    assertThat(Range.nonNegative().between(0, 5)).isEqualTo(Range.of(0, 5));
  }

  @Test
  void numberText_ofAnySize_isPlainFromAMillionthToAThousandMillionMillion() {
    assertThat(NumberText.of(0.0)).isEqualTo("0");
    assertThat(NumberText.of(-0.0)).isEqualTo("0");
    assertThat(NumberText.of(1.0e-6)).isEqualTo("0.000001");
    assertThat(NumberText.of(9.0e-7)).isEqualTo("9E-7");
    assertThat(NumberText.of(9.0e14)).isEqualTo("900000000000000");
    assertThat(NumberText.of(1.0e15)).isEqualTo("1E+15");
    assertThat(NumberText.of(-1.0e15)).isEqualTo("-1E+15");
    assertThat(NumberText.of(Double.POSITIVE_INFINITY)).isEqualTo("Infinity");
    assertThat(NumberText.of(Double.NaN)).isEqualTo("NaN");
    assertThat(NumberText.of(0.1 + 0.2)).isEqualTo("0.3");
  }
}
