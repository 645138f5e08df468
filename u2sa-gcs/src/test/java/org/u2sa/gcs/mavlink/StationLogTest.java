package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import io.dronefleet.mavlink.common.LogData;
import io.dronefleet.mavlink.common.LogEntry;
import io.dronefleet.mavlink.common.LogErase;
import io.dronefleet.mavlink.common.LogRequestData;
import io.dronefleet.mavlink.common.LogRequestEnd;
import io.dronefleet.mavlink.common.LogRequestList;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.gcs.mavlink.file.RecordingFolder;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;

/** Recordings as logs: listed, downloaded, never erased. */
class StationLogTest {
  @TempDir Path logs;

  private final byte[] recording = new byte[100_000];
  private BridgeKit kit;

  @BeforeEach
  void begin() throws IOException {
    new Random(6).nextBytes(recording);
    Files.write(logs.resolve("b.mcap"), recording);
    Files.setLastModifiedTime(logs.resolve("b.mcap"), FileTime.fromMillis(1_700_000_000_000L));
    Files.write(logs.resolve("a.ulg"), new byte[91]);
    kit =
        new BridgeKit(
            Identity.PX4,
            VehicleKind.ROVER,
            Optional.empty(),
            Optional.of(new RecordingFolder(logs)));
  }

  private List<LogEntry> list(int start, int end) {
    kit.send(
        LogRequestList.builder().targetSystem(1).targetComponent(1).start(start).end(end).build());
    return kit.received(LogEntry.class);
  }

  private List<LogData> data(int id, long offset, long count) {
    kit.send(
        LogRequestData.builder()
            .targetSystem(1)
            .targetComponent(1)
            .id(id)
            .ofs(offset)
            .count(count)
            .build());
    kit.advance(10.0);
    return kit.received(LogData.class);
  }

  @Test
  void list_allAndPart_haveSizeAndTime() {
    List<LogEntry> all = list(0, 0xFFFF);
    assertThat(all).extracting(LogEntry::id).containsExactly(1, 2);
    assertThat(all).extracting(LogEntry::size).containsExactly(91L, 100_000L);
    assertThat(all.get(1).timeUtc()).isEqualTo(1_700_000_000L);
    assertThat(all).extracting(LogEntry::numLogs).containsOnly(2);
    assertThat(list(2, 2)).extracting(LogEntry::id).containsExactly(2);
    assertThat(list(7, 9)).isEmpty();
  }

  @Test
  void list_noRecordings_answersWithNone() throws IOException {
    Files.delete(logs.resolve("a.ulg"));
    Files.delete(logs.resolve("b.mcap"));
    assertThat(list(0, 0xFFFF)).extracting(LogEntry::numLogs).containsExactly(0);
    assertThat(data(1, 0, 90)).isEmpty();
  }

  @Test
  void data_partsAndBeyondTheEnd_isTheFile() {
    list(0, 0xFFFF);
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    for (long offset = 0; offset < recording.length; offset += 46_080) {
      for (LogData each : data(2, offset, 46_080)) {
        assertThat(each.id()).isEqualTo(2);
        assertThat(each.ofs()).isEqualTo(content.size());
        content.write(each.data(), 0, each.count());
      }
    }
    assertThat(content.toByteArray()).isEqualTo(recording);
    assertThat(data(2, 100_000, 90)).extracting(LogData::count).containsExactly(0);
    assertThat(data(2, 0xFFFF_FFFFL, 0xFFFF_FFFFL)).extracting(LogData::count).containsExactly(0);
    assertThat(data(3, 0, 90)).isEmpty();
  }

  /** A pipe that nobody writes to keeps its reader waiting. */
  @Test
  @Timeout(120)
  @EnabledOnOs(OS.LINUX)
  void data_diskHangs_isRefusedAndTheBridgeGoesOn() throws Exception {
    list(0, 0xFFFF);
    Path pipe = logs.resolve("b.mcap");
    Files.delete(pipe);
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();

    assertThat(data(2, 0, 46_080)).isEmpty();
    assertThat(kit.texts()).contains("cannot be read", "the disk did not answer within 500 ms");
    assertThat(list(0, 0xFFFF)).extracting(LogEntry::numLogs).containsExactly(0);
    assertThat(kit.texts()).contains("cannot be listed", "the disk does not answer");

    Files.newOutputStream(pipe).close(); // lets the reader go on
    await().until(() -> list(0, 0xFFFF), each -> each.get(0).numLogs() == 1);
  }

  @Test
  void end_whileSending_stops() {
    list(0, 0xFFFF);
    kit.send(
        LogRequestData.builder().targetSystem(1).targetComponent(1).id(2).count(100_000).build());
    kit.send(LogRequestEnd.builder().targetSystem(1).targetComponent(1).build());
    kit.received(LogData.class);
    kit.advance(2.0);
    assertThat(kit.received(LogData.class)).isEmpty();
  }

  @Test
  void erase_isRefusedByName() {
    kit.send(LogErase.builder().targetSystem(1).targetComponent(1).build());
    assertThat(kit.texts()).isEqualTo("logs not erased: stations may only read recordings");
    assertThat(logs.resolve("b.mcap")).exists();
  }
}
