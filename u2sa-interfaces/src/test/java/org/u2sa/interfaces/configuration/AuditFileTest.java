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
    return set(load(), n);
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
    assertThat(load().revision()).isEqualTo(1);

    set(4);

    assertThat(audited()).isEqualTo(line(1, 1, 2) + line(2, 2, 4));
  }

  @Test
  void change_afterAPowerCutBetweenLogAndFile_isToldFromWhatWasDone() throws IOException {
    set(2);
    Files.write(audit, line(2, 2, 3).getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
    assertThat(load().revision()).isEqualTo(1);

    ConfigurationOutcome outcome = set(5);

    assertThat(outcome.revision()).isEqualTo(2);
    assertThat(outcome.assignments().get(0).previous()).contains("2");
    assertThat(audited().split("\n")).hasSize(4);
    assertThat(audited().split("\n")[2])
        .contains("\"revision\":2", "FAILED", "the process ended before it was written");
    assertThat(undo().assignments()).singleElement().matches(undone -> undone.value().equals("2"));
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

    XmlConfiguration configuration = load();
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

  private static final int BEGINS_ANEW = 1 << 20; // bytes
  private static final int READ_AT_MOST = 4 << 20; // bytes

  private void writeFile(int n) throws IOException {
    Files.writeString(
        file,
        "<configuration><variable name=\"N\" type=\"int\" value=\"" + n + "\"/></configuration>");
  }

  private static ConfigurationOutcome set(XmlConfiguration configuration, int n) {
    return configuration.change(
        Map.of("N", n), OptionalLong.empty(), ORIGIN, ConfigurationCheck.NONE);
  }

  private ConfigurationOutcome undo() {
    return load().undo(ORIGIN, ConfigurationCheck.NONE);
  }

  private XmlConfiguration load() {
    return XmlConfiguration.load(file);
  }

  private static String line(int revision, String outcome) {
    return "{\"revision\":"
        + revision
        + ",\"time\":\"1970-01-01T00:00:01.500Z\",\"outcome\":\""
        + outcome
        + "\",\"changes\":[]}\n";
  }

  private static String accepted(int revision) {
    return line(revision, "ACCEPTED");
  }

  private void append(String text) throws IOException {
    Files.write(
        audit,
        text.getBytes(StandardCharsets.UTF_8),
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }

  /** Lines that are no entries, of that length in all. */
  private static String filling(int length) {
    StringBuilder text = new StringBuilder();
    while (text.length() + 1_000 < length) {
      text.append("#".repeat(999)).append('\n');
    }
    return text.append("#".repeat(length - text.length() - 1)).append('\n').toString();
  }

  @Test
  void change_logOfExactlyTheLimit_goesOnInIt() throws IOException {
    append(accepted(1) + filling(BEGINS_ANEW - accepted(1).length()));

    assertThat(set(load(), 2).revision()).isEqualTo(2);

    assertThat(Files.size(audit)).isGreaterThan(BEGINS_ANEW);
    assertThat(folder.resolve("X.xml.audit.jsonl.1")).doesNotExist();
  }

  @Test
  void change_logOfOneByteMore_beginsAnewAndKeepsTheOldOneBeside() throws IOException {
    append(accepted(1) + filling(BEGINS_ANEW + 1 - accepted(1).length()));

    assertThat(set(load(), 2).revision()).isEqualTo(2);

    assertThat(Files.size(audit)).isLessThan(1_000);
    assertThat(Files.readAllLines(audit)).hasSize(2);
    assertThat(Files.size(folder.resolve("X.xml.audit.jsonl.1"))).isEqualTo(BEGINS_ANEW + 1);
    assertThat(load().revision()).isEqualTo(2);
  }

  @Test
  void revision_logAsLongAsIsRead_isThatOfItsFirstLine() throws IOException {
    append(accepted(7) + filling(READ_AT_MOST - accepted(7).length()));

    assertThat(load().revision()).isEqualTo(7);
  }

  @Test
  void revision_longerLog_isThatOfItsEnd() throws IOException {
    append(accepted(7) + filling(READ_AT_MOST) + accepted(8));

    assertThat(load().revision()).isEqualTo(8);
  }

  @Test
  void revision_longerLogReadFromWithinALine_passesItsRestOver() throws IOException {
    String tail = accepted(9);
    append("#".repeat(50) + tail + filling(READ_AT_MOST - tail.length()));

    assertThat(load().revision()).isZero();
  }

  @Test
  void change_anotherWroteMoreThanIsReadAtOnce_goesOnBehindIt() throws IOException {
    XmlConfiguration configuration = load();
    set(configuration, 2);
    set(configuration, 3); // reads what the first wrote
    append(filling(READ_AT_MOST) + accepted(5));

    assertThat(set(configuration, 4).revision()).isEqualTo(6);
  }

  @Test
  void change_logReplacedByAnotherFile_goesOnFromThatOne() throws IOException {
    XmlConfiguration configuration = load();
    set(configuration, 2);
    Path other = folder.resolve("other");
    Files.writeString(other, accepted(41) + filling(2_000));
    Files.move(audit, folder.resolve("moved"));
    Files.move(other, audit);

    assertThat(set(configuration, 3).revision()).isEqualTo(42);
  }

  @Test
  void change_logDeleted_beginsAnew() throws IOException {
    XmlConfiguration configuration = load();
    set(configuration, 2);
    Files.delete(audit);

    assertThat(set(configuration, 3).revision()).isOne();
    assertThat(Files.readAllLines(audit)).hasSize(1);
  }

  @Test
  void change_interruptedThread_readsTheLogAndStaysInterrupted() {
    set(load(), 2);
    Thread.currentThread().interrupt();

    ConfigurationOutcome outcome = set(load(), 3);

    assertThat(Thread.interrupted()).isTrue();
    assertThat(outcome.revision()).isEqualTo(2);
  }

  @Test
  void change_toWhatWasWrittenByHandMeanwhile_isNotTakenForALostOne() throws IOException {
    XmlConfiguration configuration = load();
    writeFile(2);
    assertThat(set(configuration, 2).revision()).isOne();

    assertThat(load().revision()).isOne();
    assertThat(set(load(), 3).revision()).isEqualTo(2);
  }

  @Test
  void undo_logWasEditedToAValueOfNoSuchType_isRefused() throws IOException {
    set(load(), 2);
    String edited = Files.readString(audit).replace("\"oldText\":\"1\"", "\"oldText\":\"one\"");
    Files.writeString(audit, edited);

    assertThat(undo().refusal())
        .hasValueSatisfying(
            why ->
                assertThat(why)
                    .startsWith(file + ", variable \"N\": \"one\" is not a whole number"));
  }

  @Test
  void change_oneOfTwoFailed_othersStandAndAreTold() throws IOException {
    writeFile(3);
    append(accepted(1) + accepted(2) + line(2, "FAILED"));
    append(accepted(2).replace("ACCEPTED\",", "ACCEPTED\",\"author\":\"eve\","));

    ConfigurationOutcome outcome =
        load().change(Map.of("N", 4), OptionalLong.of(1), ORIGIN, ConfigurationCheck.NONE);

    assertThat(outcome.refusal())
        .contains(
            file
                + ": is already at revision 2, not 1; since then \"eve\":  (revision 2): no change made");
  }

  @Test
  void undo_lastOfTwoFailed_takesTheFirstBack() throws IOException {
    set(load(), 2);
    append(accepted(2) + line(2, "FAILED"));

    assertThat(load().revision()).isOne();
    assertThat(undo().assignments()).singleElement().matches(undone -> undone.value().equals("1"));
  }
}
