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

/** An audit log at the sizes where it restarts or is not read from its start, or replaced. */
class LongAuditFileTest {
  private static final int BEGINS_ANEW = 1 << 20; // bytes
  private static final int READ_AT_MOST = 4 << 20; // bytes

  @TempDir Path folder;
  private Path file;
  private Path audit;

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("X.xml");
    audit = folder.resolve("X.xml.audit.jsonl");
    writeFile(1);
  }

  private void writeFile(int n) throws IOException {
    Files.writeString(
        file,
        "<configuration><variable name=\"N\" type=\"int\" value=\"" + n + "\"/></configuration>");
  }

  private static ConfigurationOutcome set(XmlConfiguration configuration, int n) {
    return configuration.change(
        Map.of("N", n),
        OptionalLong.empty(),
        new ChangeOrigin(1_500_000L, "Control", "ann"),
        ConfigurationCheck.NONE);
  }

  private ConfigurationOutcome undo() {
    return load().undo(new ChangeOrigin(0, "T", "bob"), ConfigurationCheck.NONE);
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
        load()
            .change(
                Map.of("N", 4),
                OptionalLong.of(1),
                new ChangeOrigin(0, "T", "bob"),
                ConfigurationCheck.NONE);

    assertThat(outcome.refusal())
        .contains(
            file
                + ": is at revision 2 by now, not 1; since then \"eve\":  (revision 2): nothing was"
                + " changed");
  }

  @Test
  void undo_lastOfTwoFailed_takesTheFirstBack() throws IOException {
    set(load(), 2);
    append(accepted(2) + line(2, "FAILED"));

    assertThat(load().revision()).isOne();
    assertThat(undo().assignments()).singleElement().matches(undone -> undone.value().equals("1"));
  }
}
