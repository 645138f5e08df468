package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/** What becomes of the files where a disk is full, or a file is gone. */
class RecordingFilesTest extends FilesFixture {

  private boolean isNewFile;

  private Path folder() {
    return top.resolve("run").resolve("logs");
  }

  private RecordingFiles files(Map<String, Object> values) {
    return files(folder().resolve("recording.mcap"), values, disk);
  }

  /** Records a message, if there is a file, and writes it out at once. */
  private void record(RecordingFiles files, long nanos) {
    McapWriter writer = files.at(nanos, () -> isNewFile = true);
    if (writer == null) {
      return;
    }
    try {
      if (isNewFile) {
        writer.add(new McapChannel(1, 0, "topic", "cbor", Map.of()));
        isNewFile = false;
      }
      writer.add(new McapMessage(1, sequence++, nanos, nanos, new byte[1_000]));
      writer.flush();
    } catch (IOException e) {
      files.failed(e);
    }
  }

  private List<Path> inFolder() throws IOException {
    try (Stream<Path> all = Files.list(folder())) {
      return all.sorted().toList();
    }
  }

  @Test
  void at_keptFilesAndNoRoomForAHeader_deletesTheOldestOnce() throws IOException {
    RecordingFiles files = files(Map.of("SPLIT TIME", 10.0, "KEEP", 3));
    for (int s = 0; s < 30; s++) {
      record(files, s * SECOND);
    }
    List<Path> good = inFolder();
    assertThat(good).hasSize(3);
    disk.room = 0;
    for (int s = 30; s < 90; s++) {
      record(files, s * SECOND);
    }
    assertThat(inFolder()).isEqualTo(good.subList(1, 3));
    disk.room = PLENTY;
    for (int s = 90; s < 120; s++) {
      record(files, s * SECOND);
    }
    files.end(120 * SECOND, Map.of());
    assertThat(inFolder()).hasSize(3);
    assertThat(files.written()).isEqualTo(inFolder());
  }

  @Test
  void at_oneKeptFileAndNoRoomForAHeader_keepsIt() throws IOException {
    RecordingFiles files = files(Map.of("SPLIT TIME", 10.0, "KEEP", 1));
    for (int s = 0; s < 10; s++) {
      record(files, s * SECOND);
    }
    List<Path> good = inFolder();
    disk.room = 0;
    for (int s = 10; s < 60; s++) {
      record(files, s * SECOND);
    }
    assertThat(inFolder()).isEqualTo(good).hasSize(1);
  }

  @Test
  void at_keptFilesAndRoom_deletesTheOldestWhenTheNextIsBegun() throws IOException {
    RecordingFiles files = files(Map.of("SPLIT TIME", 10.0, "KEEP", 2));
    for (int s = 0; s < 50; s++) {
      record(files, s * SECOND);
    }
    files.end(50 * SECOND, Map.of());
    assertThat(inFolder())
        .extracting(file -> file.getFileName().toString())
        .containsExactly("recording-0004.mcap", "recording-0005.mcap");
    assertThat(sequences(inFolder().get(1))).hasSize(10);
  }

  @Test
  void at_fullDiskThatIsEmptiedAgain_saysEachOnceAndKeepsWhatWasWritten() throws IOException {
    RecordingFiles files = files(Map.of());
    disk.room = 20_000;
    for (int s = 0; s < 60; s++) {
      record(files, s * SECOND);
    }
    assertThat(troubles).hasSize(1);
    assertThat(troubles.get(0)).contains("recording.mcap: No space left on device");
    long before = files.lost();
    assertThat(before).isBetween(40L, 50L);
    disk.room = PLENTY;
    for (int s = 60; s < 80; s++) {
      record(files, s * SECOND);
    }
    files.end(80 * SECOND, Map.of());
    assertThat(troubles).hasSize(2);
    assertThat(troubles.get(1)).contains("recording again; messages in between are lost");
    List<Long> written = sequences(folder().resolve("recording.mcap"));
    assertThat(written).hasSize(80 - (int) before).startsWith(0L, 1L, 2L).endsWith(78L, 79L);
  }

  @Test
  void requirePresent_folderDeleted_recordsIntoANewOneAndSaysSo() throws IOException {
    RecordingFiles files = files(Map.of());
    record(files, 0);
    Files.delete(folder().resolve("recording.mcap"));
    Files.delete(folder());
    files.requirePresent(SECOND);
    assertThat(troubles).hasSize(1);
    assertThat(troubles.get(0))
        .contains("recording.mcap: the file was deleted or moved away, with 1 messages");
    record(files, SECOND);
    files.requirePresent(2 * SECOND);
    files.end(2 * SECOND, Map.of());
    assertThat(troubles).hasSize(1);
    assertThat(files.written()).isEqualTo(inFolder()).hasSize(1);
    assertThat(sequences(files.written().get(0))).containsExactly(1L);
  }

  @Test
  void requirePresent_folderMovedAway_leavesItsFileWhole() throws IOException {
    RecordingFiles files = files(Map.of());
    record(files, 0);
    Path moved = Files.move(folder(), top.resolve("moved"));
    files.requirePresent(SECOND);
    record(files, SECOND);
    files.end(SECOND, Map.of());
    assertThat(sequences(moved.resolve("recording.mcap"))).containsExactly(0L);
    assertThat(sequences(files.written().get(0))).containsExactly(1L);
  }

  @Test
  void requirePresent_fileThere_changesNothing() throws IOException {
    RecordingFiles files = files(Map.of());
    record(files, 0);
    files.requirePresent(SECOND);
    record(files, SECOND);
    files.end(SECOND, Map.of());
    assertThat(troubles).isEmpty();
    assertThat(sequences(inFolder().get(0))).containsExactly(0L, 1L);
  }

  @Test
  void at_folderThatCannotBeMade_saysSoOnceAndBeginsWhenItCan() throws IOException {
    Path inTheWay = Files.writeString(top.resolve("run"), "a file");
    RecordingFiles files = files(Map.of());
    for (int s = 0; s < 20; s++) {
      record(files, s * SECOND);
    }
    assertThat(troubles).hasSize(1);
    Files.delete(inTheWay);
    record(files, 20 * SECOND);
    files.end(20 * SECOND, Map.of());
    assertThat(sequences(inFolder().get(0))).hasSize(1);
  }
}
