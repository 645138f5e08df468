package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapMessage;

/** What fails unexpectedly ends no thread of a recording. */
@Timeout(120)
class RecordingThreadsTest extends FilesFixture {
  @TempDir Path top;

  private final List<String> told = new CopyOnWriteArrayList<>();
  private final SmallDisk disk = new SmallDisk(1L << 30);

  private Recording recording() {
    RecorderVariables settings = settings(Map.of("COMPRESSION", "NONE", "EXECUTIONS", false));
    RecordingFiles files =
        new RecordingFiles(
            top.resolve("recording.mcap"), settings, "test", new RecordingFacts(), told::add, disk);
    return new Recording("cessna", new SystemClock(), settings, files, told::add);
  }

  private static void record(Recording recording, int number) {
    StateInformation state = new StateInformation().sensorName("gps " + number).x(1.0);
    state.freeze();
    recording.receive(Channels.STATE, state);
  }

  private static long recorded(Recording recording) throws IOException {
    long messages = 0;
    try (McapReader reader = McapReader.open(recording.written().get(0))) {
      McapCursor cursor = reader.messages(0, channel -> channel.topic().startsWith("u2sa/"));
      for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
        messages++;
      }
    }
    return messages;
  }

  @Test
  void start_fileFailsUnexpectedly_isReportedAndTheNextMessageBeginsOne() throws IOException {
    disk.failuresToCome = 1;
    Recording recording = recording();
    recording.start();
    record(recording, 1);
    record(recording, 2);
    recording.close();

    assertThat(told).anyMatch(line -> line.contains("a bug"));
    assertThat(recorded(recording)).isEqualTo(2);
    assertThat(recording.notWritten()).isZero();
  }

  @Test
  void close_endOfTheFileFailsUnexpectedly_isReported() {
    Recording recording = recording();
    recording.start();
    record(recording, 1);
    disk.failuresToCome = Integer.MAX_VALUE;
    record(recording, 2);
    recording.close();

    assertThat(told).anyMatch(line -> line.contains("a bug"));
  }

  @Test
  void force_failsUnexpectedly_isReportedAndTheNextOneIsDone() throws Exception {
    disk.failuresToCome = 0;
    FileChannel file = disk.create(top.resolve("file"));
    disk.failuresToCome = 1;
    try (DiskSync sync = new DiskSync(told::add)) {
      sync.ask(file);
      CountDownLatch reported = new CountDownLatch(1);
      while (told.isEmpty()) {
        reported.await(1, TimeUnit.MILLISECONDS);
      }
      disk.failuresToCome = 1;
      sync.ask(file);
      while (disk.failuresToCome > 0) {
        reported.await(1, TimeUnit.MILLISECONDS);
      }
    }
    assertThat(told).containsExactly("the recording cannot be synced to the disk: a bug");
  }
}
