package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a variable must be, to be got. */
class VariableErrorsTest extends RefusedFile {
  private static final VariableDeclaration<Double> BANK_LIMIT =
      VariableDeclaration.number("BANK LIMIT", "rad")
          .range(Range.of(0.0, Math.toRadians(60.0)))
          .describedAs("Largest bank that is flown.");
  private static final VariableDeclaration<Double> RADIUS =
      VariableDeclaration.number("RADIUS", "m").range(Range.nonNegative());
  private static final VariableDeclaration<Integer> PORT =
      VariableDeclaration.integer("PORT").range(Range.of(1, 65535)).ifAbsent(1883);
  private static final VariableDeclaration<String> LEVEL =
      VariableDeclaration.text("LOG LEVEL").oneOf("debug", "info").ifAbsent("info");

  @Test
  void getVariable_requiredAndMissing_describesIt() {
    assertRefused(
        () -> configuration("").getVariable(BANK_LIMIT),
        ", variable \"BANK LIMIT\": is required and missing; expected double in rad,"
            + " 0…1.047197551 (Largest bank that is flown.)");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          PORT | type='string' value='1883' | type is string, expected int
          PORT | type='int' value='70000' | 70000 is outside 1…65535
          PORT | type='int' value='1' unit='m' | unit "m" is given, but the variable has none
          BANK LIMIT | type='double' value='95' unit='deg' | 95 deg is outside 0…60 deg
          BANK LIMIT | type='double' value='1' unit='ft' | unit "ft" measures length, expected angle: rad, deg, °
          BANK LIMIT | type='double' value='1' unit='degr' | unknown unit "degr"; expected angle: rad, deg, °; did you mean "deg"?
          BANK LIMIT | type='double' value='30' unit='deg' max='90' | max 90 deg is outside 0…60 deg; a file may narrow the range, not widen it
          RADIUS | type='double' value='-1' unit='ft' | -1 ft is not at least 0 ft
          RADIUS | type='double' value='1e308' | 1E+308 is neither 0 nor of a magnitude from 1E-12 to 1E12
          RADIUS | type='double' value='1e300' unit='ft' | 3.048E+299 is neither 0 nor of a magnitude from 1E-12 to 1E12
          RADIUS | type='double' value='4.9e-324' | 4.940656458E-324 is neither 0 nor of a magnitude from 1E-12 to 1E12
          LOG LEVEL | type='string' value='loud' | "loud" is not one of "debug", "info"
          """)
  void getVariable_outsideRange_namesRange(String name, String attributes, String expected) {
    VariableDeclaration<?> declared =
        List.of(BANK_LIMIT, RADIUS, PORT, LEVEL).stream()
            .filter(variable -> variable.name().equals(name))
            .findFirst()
            .orElseThrow();
    assertRefused(
        () ->
            configuration("<variable name='" + name + "' " + attributes + "/>")
                .getVariable(declared),
        ", line 2, variable \"" + name + "\": " + expected);
  }

  @Test
  void getVariable_unknownName_suggestsTheNearest() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    assertRefused(
        () -> configuration.getVariable("PORTS"),
        ", variable \"PORTS\": not found; did you mean \"PORT\"?");
  }

  @Test
  void refuseUndeclared_misspelt_suggestsTheNearest() {
    XmlConfiguration configuration = configuration("<variable name='PROT' type='int' value='1'/>");
    configuration.getVariable(PORT);
    configuration.getVariable(LEVEL);
    assertRefused(
        configuration::refuseUndeclared,
        ", line 2, variable \"PROT\": no service declares it; did you mean \"PORT\"?");
  }

  @Test
  void refuseUndeclared_allDeclared_isContent() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    configuration.getVariable(PORT);
    configuration.refuseUndeclared();
    assertThat(configuration.getVariable("PORT")).isEqualTo(1);
  }
}
