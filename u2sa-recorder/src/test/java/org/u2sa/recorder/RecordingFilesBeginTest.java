package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;

/** When the next file of a recording is begun, its name, and what stands in it beside messages. */
class RecordingFilesBeginTest extends FilesFixture {

  private int begun;

  private RecordingFiles files(Map<String, Object> values) {
    return files(top.resolve("recording.mcap"), values, disk);
  }

  private boolean record(RecordingFiles files, long nanos) throws IOException {
    int before = begun;
    McapWriter writer = files.at(nanos, () -> begun++);
    if (writer == null) {
      return false;
    }
    if (begun > before) {
      writer.add(new McapChannel(1, 0, "topic", "cbor", Map.of()));
    }
    try {
      writer.add(new McapMessage(1, sequence++, nanos, nanos, new byte[1_000]));
    } catch (IOException e) {
      files.failed(e);
    }
    return true;
  }

  private List<String> names() throws IOException {
    try (Stream<Path> all = Files.list(top)) {
      return all.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
    }
  }

  @Test
  void at_fileAsLongAsAllowed_beginsTheNextAndLosesNothing() throws IOException {
    RecordingFiles files = files(Map.of("SPLIT MEGABYTES", 0.01));
    try (DiskSync sync = new DiskSync(troubles::add)) {
      for (int i = 0; i < 50; i++) {
        record(files, i);
        files.save(sync);
      }
    }
    files.end(50, Map.of());

    assertThat(names()).startsWith("recording-0001.mcap", "recording-0002.mcap").hasSize(begun);
    assertThat(begun).isBetween(4, 6);
    List<Long> all = new ArrayList<>();
    for (Path file : files.written()) {
      all.addAll(sequences(file));
    }
    assertThat(all).hasSize(50).isSorted();
    assertThat(sequences(files.written().get(0))).hasSizeBetween(8, 10);
  }

  @Test
  void at_timeIsUpOrTheClockJumpsBack_beginsTheNext() throws IOException {
    RecordingFiles files = files(Map.of("SPLIT TIME", 10.0));
    for (long s : new long[] {100, 109, 95, 110, 119, 109, 100, 91}) {
      record(files, s * SECOND);
    }
    files.end(91 * SECOND, Map.of());

    assertThat(files.written()).hasSize(3);
    assertThat(sequences(files.written().get(0))).containsExactlyInAnyOrder(0L, 1L, 2L);
    assertThat(sequences(files.written().get(1))).containsExactlyInAnyOrder(3L, 4L, 5L);
    assertThat(sequences(files.written().get(2))).containsExactlyInAnyOrder(6L, 7L);
  }

  @Test
  void at_nameIsTaken_addsTheNextFreeNumberAndLeavesTheOthers() throws IOException {
    Files.writeString(top.resolve("tide.mcap"), "another's");
    Files.writeString(top.resolve("tide-2.mcap"), "another's");
    RecordingFiles files = files(top.resolve("tide"), Map.of(), disk);
    record(files, 0);
    files.end(0, Map.of());

    assertThat(files.written()).containsExactly(top.resolve("tide-3.mcap"));
    assertThat(top.resolve("tide.mcap")).hasContent("another's");
    assertThat(top.resolve("tide-2.mcap")).hasContent("another's");
  }

  @Test
  void at_noRoomForAHeader_leavesNoFileAndTriesAgainAfterASecond() throws IOException {
    RecordingFiles files = files(Map.of());
    disk.room = 0;
    assertThat(record(files, 0)).isFalse();
    assertThat(names()).isEmpty();
    disk.room = 1L << 30;
    assertThat(record(files, SECOND - 1)).isFalse();
    assertThat(record(files, SECOND)).isTrue();

    files.end(SECOND, Map.of());
    assertThat(names()).containsExactly("recording.mcap");
    assertThat(files.lost()).isZero();
  }

  @Test
  void at_facts_standInEachFile() throws IOException {
    Path big = top.resolve("big.txt");
    try (RandomAccessFile file = new RandomAccessFile(big.toFile(), "rw")) {
      file.setLength((16 << 20) + 1);
    }
    Path system = Files.writeString(top.resolve("a"), "<system/>");
    facts.say("run", "seed", "7").say("run", "by", "ann");
    facts.attach("system.xml", system).attach("OPTIONS.JSON", system).attach("notes", system);
    facts.attach("big", big).attach("gone", top.resolve("gone"));
    facts.attachAtEnd(() -> Map.of("log", system, "lost log", top.resolve("lost")));
    RecordingFiles files = files(Map.of("SPLIT TIME", 10.0));
    record(files, 0);
    record(files, 10 * SECOND);
    files.end(20 * SECOND, Map.of("messages", "2"));

    try (McapReader first = McapReader.open(files.written().get(0))) {
      assertThat(first.attachmentNames()).containsExactly("system.xml", "OPTIONS.JSON", "notes");
      assertThat(first.attachment("system.xml").orElseThrow().mediaType()).isEqualTo("text/xml");
      assertThat(first.attachment("OPTIONS.JSON").orElseThrow().mediaType())
          .isEqualTo("application/json");
      assertThat(first.attachment("notes").orElseThrow().mediaType()).isEqualTo("text/plain");
      assertThat(first.attachment("notes").orElseThrow().data()).asString().isEqualTo("<system/>");
      assertThat(first.metadata())
          .contains(new McapMetadata("run", Map.of("seed", "7", "by", "ann")));
      assertThat(entries(first, "not-attached"))
          .containsEntry("big", "16777217 bytes: more than 16 MiB")
          .hasEntrySatisfying("gone", why -> assertThat(why).contains("NoSuchFileException"));
      assertThat(first.metadata()).noneMatch(one -> one.name().equals("recorder"));
    }
    try (McapReader last = McapReader.open(files.written().get(1))) {
      assertThat(last.attachmentNames())
          .containsExactly("system.xml", "OPTIONS.JSON", "notes", "log");
      assertThat(entries(last, "recorder")).containsEntry("messages", "2");
      assertThat(last.metadata())
          .anyMatch(
              one -> one.name().equals("not-attached") && one.entries().containsKey("lost log"));
    }
  }

  private static Map<String, String> entries(McapReader reader, String name) throws IOException {
    return reader.metadata().stream()
        .filter(one -> one.name().equals(name))
        .findFirst()
        .orElseThrow()
        .entries();
  }

  @Test
  void at_everyFailureIsAnother_onlySomeAreSaid() {
    int[] tries = new int[1];
    RecordingFiles files =
        files(
            top.resolve("recording.mcap"),
            Map.of(),
            file -> {
              throw new IOException("trouble " + tries[0]++);
            });
    for (int s = 0; s < 20; s++) {
      files.at(s * SECOND, () -> {});
    }
    assertThat(tries[0]).isEqualTo(20);
    assertThat(troubles).hasSize(8);
    assertThat(troubles.get(0))
        .isEqualTo(
            "recording into "
                + top.resolve("recording.mcap")
                + ": trouble 0; retrying until it works");
  }

  @Test
  void at_fileMayNotBeWritten_saysWhatHappenedBesideItsName() {
    RecordingFiles files =
        files(
            top.resolve("recording.mcap"),
            Map.of(),
            file -> {
              throw new AccessDeniedException(file.toString());
            });
    files.at(0, () -> {});
    assertThat(troubles).hasSize(1);
    assertThat(troubles.get(0)).contains(": AccessDeniedException " + top);
  }

  @Test
  void at_worksAgain_isSaidFiveSecondsAfterTheLastFailure() throws IOException {
    RecordingFiles files = files(Map.of());
    record(files, 0);
    files.failed(new IOException("odd"));
    record(files, SECOND);
    files.failed(new IOException("odd"));
    for (long nanos : new long[] {2 * SECOND, 6 * SECOND - 1}) {
      record(files, nanos);
      try (DiskSync sync = new DiskSync(troubles::add)) {
        files.save(sync);
      }
    }
    assertThat(troubles).hasSize(1);
    record(files, 6 * SECOND);
    assertThat(troubles).hasSize(2);
    assertThat(troubles.get(1)).contains("recording again");
    files.failed(new IOException("odd"));
    assertThat(troubles).as("said again after it worked").hasSize(3);
  }

  @Test
  void save_writesWhatWaitsAndHasTheDiskKeepIt() throws Exception {
    RecordingFiles files = files(Map.of());
    record(files, 0);
    Path file = top.resolve("recording.mcap");
    long before = Files.size(file);
    try (DiskSync sync = new DiskSync(troubles::add)) {
      files.save(sync);
      assertThat(Files.size(file)).isGreaterThan(before + 1_000);
      while (disk.forced == 0) {
        Thread.onSpinWait();
      }
    }
    files.end(0, Map.of());
    assertThat(files.at(-1, () -> {})).as("goes on in another").isNotNull();
  }

  @Test
  void lost_countsThoseOfAllFiles() throws IOException {
    RecordingFiles files = files(Map.of("SPLIT TIME", 10.0));
    record(files, 0);
    disk.room = 0;
    for (int s = 1; s < 5; s++) {
      record(files, s * SECOND);
    }
    files.end(5 * SECOND, Map.of());
    long ofTheFirst = files.lost();
    assertThat(ofTheFirst).isPositive();
    disk.room = 1L << 30;
    record(files, 20 * SECOND);
    files.end(21 * SECOND, Map.of());
    assertThat(files.lost()).isEqualTo(ofTheFirst);
  }

  @Test
  void requirePresent_noneWasBegun_saysNothing() {
    files(Map.of()).requirePresent(0);
    assertThat(troubles).isEmpty();
  }

  @Test
  void at_usualDisk_createsAFileThatMustNotExist() throws IOException {
    RecorderVariables settings = settings(Map.of());
    RecordingFiles files =
        new RecordingFiles(top.resolve("recording.mcap"), settings, "test", facts, troubles::add);
    record(files, 0);
    files.end(0, Map.of());
    assertThat(sequences(top.resolve("recording.mcap"))).containsExactly(0L);
    try (FileChannel any =
        FileChannel.open(top.resolve("recording.mcap"), StandardOpenOption.WRITE)) {
      assertThat(any.size()).isPositive();
    }
  }
}
