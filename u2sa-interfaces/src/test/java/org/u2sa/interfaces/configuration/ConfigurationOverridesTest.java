package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a program lays over a file, what it tolerates in it, and what a successor takes along. */
class ConfigurationOverridesTest extends RefusedFile {
  private static final VariableDeclaration<Double> BANK =
      VariableDeclaration.number("BANK", "rad").range(Range.of(0.0, 1.0)).ifAbsent(0.5);
  private static final VariableDeclaration<Integer> PORT =
      VariableDeclaration.integer("PORT").ifAbsent(1883);
  private static final VariableDeclaration<String> NAME =
      VariableDeclaration.text("NAME").ifAbsent("");
  private static final ChangeOrigin ANN = new ChangeOrigin(0, "Test", "ann");

  private static ConfigurationOutcome change(
      XmlConfiguration configuration, String name, Object value) {
    return configuration.change(
        Map.of(name, value), OptionalLong.empty(), ANN, ConfigurationCheck.NONE);
  }

  @Test
  void override_beforeTheDeclaration_winsOverTheFileAndLeavesItAlone() {
    XmlConfiguration configuration =
        configuration("<variable name='BANK' type='double' value='30' unit='deg'/>");
    configuration.override("BANK", 1); // whole, where a decimal is declared

    assertThat(configuration.getVariable(BANK)).isEqualTo(1.0);
    assertThat(file).content().contains("value='30'");
  }

  @ParameterizedTest
  @CsvSource({"0.25, 0.25", "18 deg, 0.3141592653589793", "' +1e-1rad ', 0.1"})
  void override_textWithUnit_isReadInItAndConverted(String text, double expected) {
    XmlConfiguration configuration = configuration("");
    configuration.override("BANK", text.equals("0.25") ? (Object) 0.25 : text);

    assertThat(configuration.getVariable(BANK)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "90 deg, 90 deg is outside 0…57",
    "1 m, '\"m\"'",
    "1 furlong, '\"furlong\"'",
    "much, 'type is string, expected double'"
  })
  void override_textThatTheVariableCannotTake_isRefused(String text, String reason) {
    XmlConfiguration configuration = configuration("");
    configuration.override("BANK", text);

    assertThatThrownBy(() -> configuration.getVariable(BANK))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContainingAll("\"BANK\"", reason);
  }

  @Test
  void change_ofAnOverriddenVariableWithRevision_doesNotMindWhatTheFileSays() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    configuration.override("PORT", 2);
    configuration.getVariable(PORT);

    ConfigurationOutcome outcome =
        configuration.change(Map.of("PORT", 3), OptionalLong.of(0), ANN, ConfigurationCheck.NONE);

    assertThat(outcome.refusal()).isEmpty();
    assertThat(outcome.assignments().get(0).previous()).contains("2");
    assertThat(configuration.getVariable(PORT)).isEqualTo(3);
  }

  @Test
  void override_decimalThatIsWhole_staysAProgramsWordInTheSuccessorToo() {
    XmlConfiguration configuration = configuration("");
    configuration.override("BANK", 1);

    assertThat(configuration.forSuccessor().getVariable(BANK)).isEqualTo(1.0);
  }

  @Test
  void tolerate_variableThatNobodyDeclares_isNotRefusedAndToldAsWithoutEffect() {
    XmlConfiguration configuration =
        configuration(
            "<variable name='OLD' type='int' value='1'/><variable name='PORT' type='int'"
                + " value='2'/><variable name='PROT' type='int' value='3'/>");
    configuration.getVariable(PORT);
    configuration.tolerate(List.of("OLD", "PORT", "NOWHERE"));

    assertThat(configuration.withoutEffect()).containsExactly("OLD");
    assertRefused(
        configuration::refuseUndeclared,
        ", line 2, variable \"PROT\": no service declares it; did you mean \"PORT\"?");
    configuration.tolerate(List.of("PROT"));
    configuration.refuseUndeclared();
  }

  @Test
  void tolerated_declaredAndToleratedOnes_areWhatASuccessorNeedNotDeclare() {
    XmlConfiguration configuration =
        configuration(
            "<variable name='OLD' type='int' value='1'/><variable name='PORT' type='int'"
                + " value='2'/>");
    configuration.tolerate(List.of("OLD"));
    configuration.getVariable(PORT);
    assertThat(configuration.tolerated()).containsExactlyInAnyOrder("OLD", "PORT");

    XmlConfiguration successor = configuration.forSuccessor();

    successor.refuseUndeclared();
    assertThat(successor.declared()).isEmpty();
    assertThat(successor.withoutEffect()).containsExactlyInAnyOrder("OLD", "PORT");
    assertThat(successor.origin()).isEqualTo(file.toString());
  }

  @Test
  void forSuccessor_afterChanges_goesOnWithValuesAndRevision() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    change(configuration, "PORT", 2);

    XmlConfiguration successor = configuration.forSuccessor();

    assertThat(successor.getVariable(PORT)).isEqualTo(2);
    assertThat(successor.revision()).isOne();
    assertThat(change(successor, "PORT", 3).revision()).isEqualTo(2);
    assertThat(configuration.getVariable("PORT")).isEqualTo(2);
  }

  @Test
  void write_notInEffectYet_isSeenByTheNextChangeAndByASuccessor() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    configuration.getVariable(PORT);
    WrittenChange first =
        configuration.write(Map.of("PORT", 2), OptionalLong.empty(), ANN, ConfigurationCheck.NONE);
    assertThat(first.outcome().accepted()).isTrue();
    assertThat(configuration.getVariable(PORT)).isEqualTo(1);
    assertThat(configuration.forSuccessor().getVariable(PORT)).isEqualTo(2);

    WrittenChange second =
        configuration.write(Map.of("PORT", 3), OptionalLong.empty(), ANN, ConfigurationCheck.NONE);
    assertThat(second.outcome().assignments().get(0).previous()).contains("2");

    second.takeEffect();
    assertThat(configuration.getVariable(PORT)).isEqualTo(3);
    first.takeEffect(); // has happened already
    assertThat(configuration.getVariable(PORT)).isEqualTo(3);
  }

  @Test
  void write_ofTwoTheFirstTakesEffect_theSecondStillWaits() {
    XmlConfiguration configuration = configuration("<variable name='PORT' type='int' value='1'/>");
    configuration.getVariable(PORT);
    WrittenChange first =
        configuration.write(Map.of("PORT", 2), OptionalLong.empty(), ANN, ConfigurationCheck.NONE);
    WrittenChange second =
        configuration.write(Map.of("PORT", 3), OptionalLong.empty(), ANN, ConfigurationCheck.NONE);

    first.takeEffect();
    assertThat(configuration.getVariable(PORT)).isEqualTo(2);
    second.takeEffect();
    assertThat(configuration.getVariable(PORT)).isEqualTo(3);
  }

  @Test
  void undo_inMemory_remembersTwoHundredChanges() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of("PORT", 0));
    for (int i = 1; i <= 201; i++) {
      assertThat(change(configuration, "PORT", i).accepted()).isTrue();
    }
    assertThat(configuration.revision()).isEqualTo(201);
    int undone = 0;
    while (configuration.undo(ANN, ConfigurationCheck.NONE).accepted()) {
      undone++;
    }

    assertThat(undone).isEqualTo(100); // each undo is an entry as well, and pushes one out
  }

  @ParameterizedTest
  @CsvSource({"0.25, 0.25", "18 deg, 0.3141592653589793"})
  void undo_ofAChangeThatReplacedAnOverride_restoresTheOverrideAndTheFile(
      String text, double expected) {
    XmlConfiguration configuration =
        configuration("<variable name='BANK' type='double' value='30' unit='deg'/>");
    configuration.override("BANK", text.equals("0.25") ? (Object) 0.25 : text);
    configuration.getVariable(BANK);
    change(configuration, "BANK", 1);
    change(configuration, "BANK", 0);
    XmlConfiguration successor = configuration.forSuccessor();
    assertThat(successor.getVariable(BANK)).isEqualTo(0.0);

    assertThat(successor.undo(ANN, ConfigurationCheck.NONE).accepted()).isTrue();
    assertThat(successor.getVariable(BANK)).isCloseTo(1.0, within(1e-12));

    ConfigurationOutcome undone = successor.undo(ANN, ConfigurationCheck.NONE);
    assertThat(undone.assignments().get(0).value()).contains(String.valueOf(expected));
    assertThat(successor.getVariable(BANK)).isEqualTo(expected);
    assertThat(successor.forSuccessor().getVariable(BANK)).isEqualTo(expected);
    assertThat(file).content().contains("value='30'");
    assertThat(XmlConfiguration.load(file).getVariable(BANK)).isCloseTo(0.5236, within(1e-4));
  }

  @Test
  void undo_ofAChangeBeforeTheOverride_leavesTheOverrideInForce() {
    XmlConfiguration earlier = configuration("<variable name='PORT' type='int' value='1'/>");
    change(earlier, "PORT", 2);
    XmlConfiguration configuration = XmlConfiguration.load(file);
    configuration.override("PORT", 3);
    configuration.getVariable(PORT);

    assertThat(configuration.undo(ANN, ConfigurationCheck.NONE).accepted()).isTrue();
    assertThat(configuration.getVariable(PORT)).isEqualTo(3);
    assertThat(XmlConfiguration.load(file).getVariable(PORT)).isEqualTo(1);
  }

  @Test
  void overrides_takenOverByAnotherConfiguration_giveTheSameValues() {
    InferredValue name = new InferredValue("007", 7);
    XmlConfiguration configuration = configuration("");
    configuration.override("BANK", "18 deg");
    configuration.override("NAME", name);
    configuration.override("PORT", 4);
    XmlConfiguration declared = configuration.forSuccessor();
    declared.getVariable(BANK);
    declared.getVariable(NAME);

    for (XmlConfiguration each : List.of(configuration, declared, declared.forSuccessor())) {
      XmlConfiguration other = XmlConfiguration.load(file);
      each.overrides().forEach(other::override);
      assertThat(other.getVariable(BANK)).isEqualTo(0.3141592653589793);
      assertThat(other.getVariable(NAME)).isEqualTo("007");
      assertThat(other.getVariable(PORT)).isEqualTo(4);
    }
  }

  @Test
  void forSuccessor_inferredTextChanged_hasTheNewText() {
    XmlConfiguration configuration = configuration("");
    configuration.override("NAME", new InferredValue("007", 7));
    configuration.getVariable(NAME);
    change(configuration, "NAME", "008");

    assertThat(configuration.forSuccessor().getVariable(NAME)).isEqualTo("008");
    assertThat(configuration.overrides()).containsEntry("NAME", "008");
  }
}
