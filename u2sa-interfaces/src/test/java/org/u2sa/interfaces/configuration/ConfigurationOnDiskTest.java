package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** In which order a change reaches the disk, as which user's files, and what it reads for it. */
@Timeout(120)
@DisabledOnOs(OS.WINDOWS)
class ConfigurationOnDiskTest {
  private static final String AUDIT = "X.xml.audit.jsonl";

  @TempDir Path folder;
  private final RecordingFileSystem disk = new RecordingFileSystem();
  private Path file;

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("X.xml");
    Files.writeString(
        file,
        "<configuration>\n<variable name=\"N\" type=\"int\" value=\"0\"/>\n</configuration>\n");
  }

  private XmlConfiguration load() {
    return XmlConfiguration.load(disk.of(file));
  }

  private List<String> changing() {
    return disk.calls().stream()
        .filter(call -> !call.startsWith("read") && !call.startsWith("delete"))
        .toList();
  }

  @Test
  void change_first_logIsOnTheDiskBeforeTheFileIsWrittenBesideAndRenamed() {
    assertThat(load().setVariable("N", 1)).isTrue();

    assertThat(changing())
        .containsExactly(
            "create " + AUDIT,
            "sync " + folder.getFileName(),
            "write " + AUDIT,
            "sync " + AUDIT,
            "create *.tmp",
            "write *.tmp",
            "sync *.tmp",
            "rename *.tmp → X.xml [ATOMIC_MOVE, REPLACE_EXISTING]",
            "sync " + folder.getFileName());
  }

  @Test
  void change_further_logIsSyncedEachTime() {
    XmlConfiguration configuration = load();
    configuration.setVariable("N", 1);
    int before = changing().size();
    configuration.setVariable("N", 2);

    assertThat(changing().subList(before, changing().size()))
        .startsWith("write " + AUDIT, "sync " + AUDIT)
        .endsWith(
            "sync *.tmp",
            "rename *.tmp → X.xml [ATOMIC_MOVE, REPLACE_EXISTING]",
            "sync " + folder.getFileName());
  }

  @Test
  void change_refused_isSyncedInTheLogAndTheFileIsLeftAlone() {
    XmlConfiguration configuration = load();
    configuration.setVariable("N", 1);
    int before = changing().size();

    assertThat(configuration.change("N", "many")).isPresent();

    assertThat(changing().subList(before, changing().size()))
        .containsExactly("write " + AUDIT, "sync " + AUDIT);
  }

  /** 60 refused changes of 3,500 variables each made a log of 46 MB, which each change read. */
  @Test
  void change_thousandsRefused_logStaysSmallAndIsNotReadAgain() throws IOException {
    XmlConfiguration configuration = load();
    configuration.setVariable("N", 1);
    Map<String, String> many = new LinkedHashMap<>();
    for (int i = 0; i < 3_500; i++) {
      many.put("NO SUCH VARIABLE " + i, "x".repeat(300));
    }
    for (int i = 0; i < 300; i++) {
      ConfigurationOutcome outcome =
          configuration.change(
              many,
              OptionalLong.empty(),
              new ChangeOrigin(i, "Test", "mallory"),
              ConfigurationCheck.NONE);
      assertThat(outcome.refusal()).hasValueSatisfying(why -> assertThat(why).hasSizeLessThan(500));
      assertThat(outcome.assignments()).hasSizeLessThan(20);
    }

    long read =
        disk.calls().stream()
            .filter(call -> call.startsWith("read " + AUDIT))
            .mapToLong(call -> Math.max(0, Long.parseLong(call.split(" ")[2])))
            .sum();
    assertThat(Files.size(folder.resolve(AUDIT))).isLessThan(1_100_000);
    assertThat(read).isLessThan(4_000_000); // 300 lines of 4 kB once, and some again as it is kept
    assertThat(configuration.revision()).isEqualTo(1);
    ConfigurationOutcome undone =
        XmlConfiguration.load(file)
            .undo(new ChangeOrigin(0, "Test", "ann"), ConfigurationCheck.NONE);
    assertThat(undone.refusal()).as("what was refused has not pushed the change out").isEmpty();
    assertThat(undone.revision()).isEqualTo(2);
  }

  @Test
  void change_anotherProcessHoldsTheLock_isRefusedAsLocked() throws IOException {
    XmlConfiguration configuration = load();
    try (FileChannel other =
            FileChannel.open(
                folder.resolve(".configuration.lock"),
                StandardOpenOption.CREATE,
                StandardOpenOption.WRITE);
        FileLock lock = other.lock()) {
      assertThat(lock.isValid()).isTrue();
      assertThat(configuration.change("N", 1))
          .hasValueSatisfying(
              why -> assertThat(why).contains(".configuration.lock is locked: another writer"));
    }
    assertThat(configuration.setVariable("N", 1)).isTrue();
  }

  @Test
  void change_fileOfAnotherUserAndMode_staysTheirsAndSoIsTheLog() throws Exception {
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
    boolean root = (Integer) Files.getAttribute(file, "unix:uid") == 0;
    if (root) { // nobody else may give files away
      Files.setAttribute(file, "unix:uid", 12_345);
      Files.setAttribute(file, "unix:gid", 23_456);
    }
    Map<String, Object> before = Files.readAttributes(file, "unix:uid,gid,permissions");

    assertThat(load().setVariable("N", 1)).isTrue();

    assertThat(Files.readAttributes(file, "unix:uid,gid,permissions")).isEqualTo(before);
    assertThat(Files.readAttributes(folder.resolve(AUDIT), "unix:uid,gid,permissions"))
        .isEqualTo(before);
  }

  @Test
  void change_logIsALink_isRefusedAndNothingIsWrittenThroughIt() throws IOException {
    Path other = Files.writeString(folder.resolve("other"), "precious");
    Files.createSymbolicLink(folder.resolve(AUDIT), other);

    assertThat(load().change("N", 1))
        .hasValueSatisfying(why -> assertThat(why).contains("is not a regular file"));

    assertThat(other).hasContent("precious");
    assertThat(Files.readString(file)).contains("value=\"0\"");
  }

  @Test
  void change_pipeInPlaceOfLockOrFile_isRefusedAtOnce() throws Exception {
    XmlConfiguration configuration = load();
    Path lock = folder.resolve(".configuration.lock");
    pipe(lock);
    assertThat(configuration.change("N", 1))
        .hasValueSatisfying(why -> assertThat(why).contains(lock + " is not a regular file"));
    Files.delete(lock);
    Files.delete(file);
    pipe(file);
    assertThat(configuration.change("N", 1))
        .hasValueSatisfying(why -> assertThat(why).contains("expected a regular file"));
  }

  private static void pipe(Path path) throws IOException, InterruptedException {
    assertThat(new ProcessBuilder("mkfifo", path.toString()).start().waitFor()).isZero();
  }
}
