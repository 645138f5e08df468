package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What a variable must be, to be got. */
class VariableErrorsTest extends RefusedFile {
  private static final VariableDeclaration<Double> BANK_LIMIT =
      VariableDeclaration.number("BANK LIMIT", "rad")
          .range(Range.of(0.0, Math.toRadians(60.0)))
          .describedAs("Largest bank that is flown.");
  private static final VariableDeclaration<Integer> PORT =
      VariableDeclaration.integer("PORT").range(Range.of(1, 65535)).ifAbsent(1883);
  private static final VariableDeclaration<String> LEVEL =
      VariableDeclaration.text("LOG LEVEL").oneOf("debug", "info").ifAbsent("info");

  private void assertDeclarationRefused(
      VariableDeclaration<?> variable, String attributes, String after) {
    XmlConfiguration configuration = configuration("<variable " + attributes + "/>");
    assertRefused(() -> configuration.getVariable(variable), after);
  }

  @Test
  void getVariable_requiredAndMissing_describesIt() {
    assertRefused(
        () -> configuration("").getVariable(BANK_LIMIT),
        ", variable \"BANK LIMIT\": is required and missing; expected double in rad,"
            + " 0…1.047197551 (Largest bank that is flown.)");
  }

  @Test
  void getVariable_anotherType_namesBoth() {
    assertDeclarationRefused(
        PORT,
        "name='PORT' type='string' value='1883'",
        ", line 2, variable \"PORT\": type is string, expected int");
  }

  @Test
  void getVariable_outsideRange_namesRange() {
    assertDeclarationRefused(
        PORT,
        "name='PORT' type='int' value='70000'",
        ", line 2, variable \"PORT\": 70000 is outside 1…65535");
  }

  @Test
  void getVariable_outsideRangeInTheFilesUnit_speaksTheFilesUnit() {
    assertDeclarationRefused(
        BANK_LIMIT,
        "name='BANK LIMIT' type='double' value='95' unit='deg'",
        ", line 2, variable \"BANK LIMIT\": 95 deg is outside 0…60 deg");
  }

  @Test
  void getVariable_unitOfAnotherKind_listsThoseThatWouldDo() {
    assertDeclarationRefused(
        BANK_LIMIT,
        "name='BANK LIMIT' type='double' value='1' unit='ft'",
        ", line 2, variable \"BANK LIMIT\": unit \"ft\" measures length, expected angle: rad, deg, °");
  }

  @Test
  void getVariable_unknownUnit_listsThoseThatWouldDo() {
    assertDeclarationRefused(
        BANK_LIMIT,
        "name='BANK LIMIT' type='double' value='1' unit='degr'",
        ", line 2, variable \"BANK LIMIT\": unknown unit \"degr\"; expected angle: rad, deg, °;"
            + " did you mean \"deg\"?");
  }

  @Test
  void getVariable_unitOfAVariableWithoutOne_saysSo() {
    assertDeclarationRefused(
        PORT,
        "name='PORT' type='int' value='1' unit='m'",
        ", line 2, variable \"PORT\": unit \"m\" is given, the variable has none");
  }

  @Test
  void getVariable_fileWidensRange_isRefused() {
    assertDeclarationRefused(
        BANK_LIMIT,
        "name='BANK LIMIT' type='double' value='30' unit='deg' max='90'",
        ", line 2, variable \"BANK LIMIT\": max 90 deg is outside 0…60 deg;"
            + " a file may narrow the range, not widen it");
  }

  @Test
  void getVariable_noneOfTheChoices_listsThem() {
    assertDeclarationRefused(
        LEVEL,
        "name='LOG LEVEL' type='string' value='loud'",
        ", line 2, variable \"LOG LEVEL\": \"loud\" is not one of \"debug\", \"info\"");
  }

  @Test
  void getVariable_unknownName_suggestsTheNearest() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    assertRefused(
        () -> configuration.getVariable("PORTS"),
        ", variable \"PORTS\": there is none; did you mean \"PORT\"?");
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
