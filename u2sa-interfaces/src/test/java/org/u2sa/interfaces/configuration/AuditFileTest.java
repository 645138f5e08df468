package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The audit log and what a power cut leaves of it. */
class AuditFileTest {
  private static final String FILE =
      "<configuration>\n<variable name=\"N\" type=\"int\" value=\"1\"/>\n</configuration>\n";
  private static final ChangeOrigin ORIGIN = new ChangeOrigin(1_500_000L, "Control", "ann");

  @TempDir Path folder;
  private Path file;
  private Path audit;

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("X.xml");
    audit = folder.resolve("X.xml.audit.jsonl");
    Files.write(file, FILE.getBytes(StandardCharsets.UTF_8));
  }

  private ConfigurationOutcome set(int n) {
    return XmlConfiguration.load(file)
        .change(Map.of("N", n), OptionalLong.empty(), ORIGIN, ConfigurationCheck.NONE);
  }

  private String audited() throws IOException {
    return new String(Files.readAllBytes(audit), StandardCharsets.UTF_8);
  }

  private static String line(int revision, int from, int to) {
    return "{\"revision\":"
        + revision
        + ",\"time\":\"1970-01-01T00:00:01.500Z\",\"service\":\"Control\",\"author\":\"ann\","
        + "\"outcome\":\"ACCEPTED\",\"changes\":[{\"variable\":\"N\",\"old\":\""
        + from
        + "\",\"new\":\""
        + to
        + "\",\"oldText\":\""
        + from
        + "\",\"newText\":\""
        + to
        + "\"}]}\n";
  }

  @Test
  void change_accepted_isOneLineThatTellsAll() throws IOException {
    set(2);
    set(3);

    assertThat(audited()).isEqualTo(line(1, 1, 2) + line(2, 2, 3));
  }

  @Test
  void change_afterATornLine_writesOverTheTornOne() throws IOException {
    set(2);
    Files.write(
        audit,
        line(2, 2, 3).substring(0, 90).getBytes(StandardCharsets.UTF_8),
        StandardOpenOption.APPEND);
    assertThat(XmlConfiguration.load(file).revision()).isEqualTo(1);

    set(4);

    assertThat(audited()).isEqualTo(line(1, 1, 2) + line(2, 2, 4));
  }

  @Test
  void change_afterAPowerCutBetweenLogAndFile_isToldFromWhatWasDone() throws IOException {
    set(2);
    Files.write(audit, line(2, 2, 3).getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
    assertThat(XmlConfiguration.load(file).revision()).isEqualTo(1);

    ConfigurationOutcome outcome = set(5);

    assertThat(outcome.revision()).isEqualTo(2);
    assertThat(outcome.assignments().get(0).previous()).contains("2");
    assertThat(audited().split("\n")).hasSize(4);
    assertThat(audited().split("\n")[2])
        .contains("\"revision\":2", "FAILED", "the process ended before it was written");
    assertThat(XmlConfiguration.load(file).undo(ORIGIN, ConfigurationCheck.NONE).assignments())
        .singleElement()
        .matches(undone -> undone.value().equals("2"));
  }

  @Test
  void change_linesThatAreNoEntries_arePassedOver() throws IOException {
    set(2);
    Files.write(
        audit,
        "\n# by hand\n{}\n[1]\n{\"revision\":7}\n".getBytes(StandardCharsets.UTF_8),
        StandardOpenOption.APPEND);

    assertThat(set(3).revision()).isEqualTo(2);
  }

  @Test
  void revision_hugeRefusedAndAcceptedChanges_isFoundByLongerReading() throws IOException {
    set(2);
    StringBuilder refusals = new StringBuilder();
    while (refusals.length() < 300_000) {
      refusals.append(line(1, 2, 3).replace("ACCEPTED", "REFUSED"));
    }
    Files.write(
        audit, refusals.toString().getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);

    XmlConfiguration configuration = XmlConfiguration.load(file);
    assertThat(configuration.revision()).isEqualTo(1);
    assertThat(configuration.undo(ORIGIN, ConfigurationCheck.NONE).accepted()).isTrue();
    assertThat(configuration.getVariable("N")).isEqualTo(1);
  }

  @Test
  void change_auditLogCannotBeWritten_isRefused() throws IOException {
    Files.createDirectory(audit);

    assertThat(set(2).refusal().get())
        .startsWith(file + ", variable \"N\": cannot be written, the old value stays: ");
    assertThat(new String(Files.readAllBytes(file), StandardCharsets.UTF_8)).isEqualTo(FILE);
  }
}
