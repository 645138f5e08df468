package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.units.NumberText;

/** What a declaration says, and when two declarations or two ranges are the same. */
class VariableDeclarationTest {
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
