package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Limits, units and descriptions that a file adds to a declaration. */
class FileLimitsTest extends RefusedFile {
  private static final VariableDeclaration<Double> BANK =
      VariableDeclaration.number("BANK", "rad").range(Range.of(0.0, Math.toRadians(60.0)));
  private static final VariableDeclaration<Double> GAP =
      VariableDeclaration.number("GAP", "m").range(Range.of(0.0, 0.001));

  @Test
  void getVariable_fileNarrowsTheRange_holdsTheNarrowerOne() {
    XmlConfiguration configuration =
        configuration(
            "<variable name='BANK' type='double' value='30' unit='deg' min='10' max='50'/>");
    assertThat(configuration.getVariable(BANK)).isEqualTo(Math.toRadians(30));

    assertThat(configuration.change("BANK", Math.toRadians(50.1))).isPresent();
    assertThat(configuration.change("BANK", Math.toRadians(9.9))).isPresent();
    assertThat(configuration.change("BANK", Math.toRadians(49.9))).isEmpty();
  }

  @Test
  void getVariable_conversionOffByRounding_isTheLimitItself() {
    XmlConfiguration configuration =
        configuration("<variable name='GAP' type='double' value='1.0000000005' unit='mm'/>");

    assertThat(configuration.getVariable(GAP)).isEqualTo(0.001);
  }

  @Test
  void getVariable_beyondRounding_isRefused() {
    XmlConfiguration configuration =
        configuration("<variable name='GAP' type='double' value='1.0000001' unit='mm'/>");

    assertRefused(
        () -> configuration.getVariable(GAP),
        ", line 2, variable \"GAP\": 1.0000001 mm is outside 0…1 mm");
  }

  @Test
  void change_outsideTheRange_isRefused() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of("GAP", 0.0005));
    configuration.getVariable(GAP);

    assertThat(configuration.change("GAP", 0.002))
        .contains("test, variable \"GAP\": 0.002 m is outside 0…0.001 m");
    assertThat(configuration.getVariable(GAP)).isEqualTo(0.0005);
  }

  @Test
  void describe_choices_areListed() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of());
    configuration.getVariable(
        VariableDeclaration.text("LEVEL").oneOf("debug", "info").ifAbsent("info"));

    assertThat(configuration.describe())
        .singleElement()
        .extracting(ConfigurationVariable::choices)
        .isEqualTo(List.of("debug", "info"));
  }

  @Test
  void describe_descriptionOfTheFile_standsInWhereTheProgramGivesNone() {
    XmlConfiguration configuration =
        configuration(
            "<variable name='A' type='int' value='1' description='of the file'/>"
                + "<variable name='B' type='int' value='1' description='of the file'/>"
                + "<variable name='C' type='int' value='1' description='of the file'/>");
    configuration.getVariable(VariableDeclaration.integer("A"));
    configuration.getVariable(VariableDeclaration.integer("B").describedAs("of the program"));

    assertThat(configuration.describe())
        .extracting(ConfigurationVariable::description)
        .containsExactly("of the file", "of the program", "of the file");
  }

  @Test
  void load_contentOfAVariable_isRefused() {
    assertRefused(
        () -> configuration("<variable name='A' type='int' value='1'>2</variable>"),
        ", line 2, <variable>: unexpected text \"2\"");
    assertRefused(
        () -> configuration("<variable name='A' type='int' value='1'><b/></variable>"),
        ", line 2, <b>: unknown element in <variable>; no element is expected here");
  }

  @Test
  void change_valueThatTheFilesUnitCannotHold_isRefused() {
    XmlConfiguration configuration =
        configuration("<variable name='Z' type='double' value='1' unit='mm'/>");
    configuration.getVariable(VariableDeclaration.number("Z", "km"));

    assertThat(configuration.change("Z", 1.0e305)).isPresent();
    assertThat(configuration.getVariable("Z")).isEqualTo(1.0e-6);
  }
}
