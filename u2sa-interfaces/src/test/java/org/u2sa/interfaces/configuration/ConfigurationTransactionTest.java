package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.contract.ConfigurationAssignment;

/** Several variables at once, two writers, undo. */
class ConfigurationTransactionTest {
  private static final String FILE =
      "<configuration> <!-- tuned by hand -->\n"
          + "  <variable name=\"BANK\" type=\"double\" value=\"30\" unit=\"deg\"/>\n"
          + "  <variable name=\"LOOP\" type=\"boolean\" value=\"false\"/>\n"
          + "</configuration>\n";
  private static final VariableDeclaration<Double> BANK =
      VariableDeclaration.number("BANK", "rad").range(Range.of(0.0, 1.0)).ifAbsent(0.5);
  private static final VariableDeclaration<Boolean> LOOP =
      VariableDeclaration.flag("LOOP").ifAbsent(false);
  private static final VariableDeclaration<Double> SPEED =
      VariableDeclaration.number("SPEED", "m/s").range(Range.of(20.0, 60.0)).ifAbsent(45.0);

  @TempDir Path folder;
  private Path file;
  private XmlConfiguration configuration;

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("X.xml");
    Files.write(file, FILE.getBytes(StandardCharsets.UTF_8));
    configuration = load();
  }

  private XmlConfiguration load() {
    XmlConfiguration loaded = XmlConfiguration.load(file);
    loaded.getVariable(BANK);
    loaded.getVariable(LOOP);
    loaded.getVariable(SPEED);
    return loaded;
  }

  private String text() throws IOException {
    return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
  }

  private List<String> audit() throws IOException {
    return Files.readAllLines(folder.resolve("X.xml.audit.jsonl"), StandardCharsets.UTF_8);
  }

  private static Map<String, Object> two(Object bank, Object speed) {
    Map<String, Object> two = new LinkedHashMap<>();
    two.put("BANK", bank);
    two.put("SPEED", speed);
    return two;
  }

  private static ChangeOrigin by(String author) {
    return new ChangeOrigin(1_500_000L, "Control", author);
  }

  private ConfigurationOutcome change(Map<String, ?> wanted) {
    return configuration.change(wanted, OptionalLong.empty(), by("ann"), ConfigurationCheck.NONE);
  }

  private ConfigurationOutcome undo() {
    return configuration.undo(by("bob"), ConfigurationCheck.NONE);
  }

  @Test
  void change_twoVariables_bothAreSetWithOneRevision() throws IOException {
    ConfigurationOutcome outcome = change(two("0.25", 50));

    assertThat(outcome.refusal()).isEmpty();
    assertThat(outcome.revision()).isEqualTo(1);
    assertThat(outcome.changed()).containsExactly("BANK", "SPEED");
    assertThat(outcome.assignments())
        .extracting(
            ConfigurationAssignment::variableName,
            ConfigurationAssignment::value,
            assignment -> assignment.previous().orElse(""))
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple("BANK", "0.25", "0.5235987755982988"),
            org.assertj.core.groups.Tuple.tuple("SPEED", "50.0", "45.0"));
    assertThat(text()).contains("name=\"SPEED\" type=\"double\" value=\"50.0\" unit=\"m/s\"");
    assertThat(load().getVariable("BANK")).isEqualTo(0.25);
    assertThat(load().revision()).isEqualTo(1);
  }

  @Test
  void change_oneOfTwoRefused_neitherIsSet() throws IOException {
    ConfigurationOutcome outcome = change(two(0.25, 99));

    assertThat(outcome.refusal()).get().asString().endsWith("99 m/s is outside 20…60 m/s");
    assertThat(outcome.changed()).isEmpty();
    assertThat(text()).isEqualTo(FILE);
    assertThat(configuration.getVariable("BANK")).isEqualTo(Math.toRadians(30.0));
    assertThat(audit())
        .singleElement()
        .asString()
        .contains("\"REFUSED\"", "\"ann\"", "outside 20…60 m/s")
        .contains("{\"variable\":\"SPEED\",\"new\":\"99\"}");
  }

  @Test
  void change_refusedByTheCheck_seesAllValuesAndWritesNothing() throws IOException {
    ConfigurationOutcome outcome =
        configuration.change(
            two(0.25, 50),
            OptionalLong.empty(),
            by("ann"),
            values ->
                Optional.of("BANK " + values.get("BANK") + " with LOOP " + values.get("LOOP")));

    assertThat(outcome.refusal()).contains(file + ": BANK 0.25 with LOOP false");
    assertThat(text()).isEqualTo(FILE);
  }

  @Test
  void change_revisionOfAnotherState_isRefusedAndSaysWhoChangedWhat() throws IOException {
    change(Map.of("SPEED", 50));

    ConfigurationOutcome outcome =
        configuration.change(
            Map.of("BANK", 0.1), OptionalLong.of(0), by("bob"), ConfigurationCheck.NONE);

    assertThat(outcome.refusal())
        .contains(
            file
                + ": is already at revision 1, not 0; since then \"ann\": \"SPEED\" 45.0 → 50.0"
                + " (revision 1): no change made");
    assertThat(configuration.getVariable("BANK")).isEqualTo(Math.toRadians(30.0));
  }

  @Test
  void change_revisionSeenButFileEditedByHand_isRefused() throws IOException {
    Files.write(file, FILE.replace("30", "20").getBytes(StandardCharsets.UTF_8));

    assertThat(
            configuration
                .change(Map.of("BANK", 0.1), OptionalLong.of(0), by("bob"), ConfigurationCheck.NONE)
                .refusal())
        .contains(
            file
                + ", variable \"BANK\": is 20 in the file, not 30 as the service read it;"
                + " to overwrite it, omit the revision");
    assertThat(change(Map.of("BANK", 0.1)).assignments().get(0).previous())
        .contains(String.valueOf(Math.toRadians(20.0)));
  }

  @Test
  void change_toTheValueThatStands_isAcceptedWithoutARevision() throws IOException {
    ConfigurationOutcome outcome = change(Map.of("LOOP", "FALSE"));

    assertThat(outcome.accepted()).isTrue();
    assertThat(outcome.changed()).isEmpty();
    assertThat(outcome.revision()).isZero();
    assertThat(text()).isEqualTo(FILE);
  }

  @Test
  void undo_afterTwoChanges_takesOneAfterTheOtherBackToTheLastByte() throws IOException {
    change(two(0.25, 50));
    String once = text();
    change(Map.of("LOOP", true));

    assertThat(undo().assignments().get(0).variableName()).isEqualTo("LOOP");
    assertThat(text()).isEqualTo(once);
    assertThat(undo().changed()).containsExactly("BANK", "SPEED");

    assertThat(text()).isEqualTo(FILE);
    assertThat(configuration.getVariable("BANK")).isEqualTo(Math.toRadians(30.0));
    assertThat(configuration.getVariable("SPEED")).isEqualTo(45.0);
    assertThat(configuration.revision()).isEqualTo(4);
    assertThat(undo().refusal()).contains(file + ": there is no recorded change to undo");
  }

  @Test
  void undo_inANewProcess_takesTheOldOnesChangeBack() throws IOException {
    change(Map.of("LOOP", true));
    configuration = load();

    assertThat(undo().accepted()).isTrue();

    assertThat(text()).isEqualTo(FILE);
    assertThat(configuration.getVariable("LOOP")).isEqualTo(false);
    assertThat(audit().get(1)).contains("\"bob\"", "\"undoes\":1");
  }

  @Test
  void undo_editedByHandSince_isRefused() throws IOException {
    change(Map.of("LOOP", true));
    Files.write(file, text().replace("true", "TRUE").getBytes(StandardCharsets.UTF_8));

    assertThat(undo().refusal())
        .contains(
            file + ", variable \"LOOP\": is TRUE, not true as revision 1 left it: not undone");
  }

  @Test
  void inMemory_changeAndUndo_workWithoutAFile() {
    configuration = XmlConfiguration.inMemory("memory", Map.of("LOOP", false));
    configuration.getVariable(LOOP);
    configuration.getVariable(SPEED);

    change(Map.of("LOOP", true, "SPEED", 50));
    assertThat(configuration.getVariable(SPEED)).isEqualTo(50.0);
    assertThat(undo().accepted()).isTrue();

    assertThat(configuration.getVariable(SPEED)).isEqualTo(45.0);
    assertThat(configuration.getVariable(LOOP)).isFalse();
    assertThat(configuration.revision()).isEqualTo(2);
  }
}
