package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.LockstepClock;

/** A replay is what the recorded link was, at the times at which it was, or faster. */
class ReplayLinkTest {
  private static final long TICK_MICROS = 100_000;

  @TempDir Path folder;
  private Path file;

  @BeforeEach
  void file() {
    file = folder.resolve("test.rec");
  }

  /** Runs a link as a service does; a line for each turn: when, there or not, connection, bytes. */
  private static List<String> seen(ByteLink link, LockstepClock clock, int turns, Script script)
      throws InterruptedException {
    List<String> lines = new ArrayList<>();
    byte[] buffer = new byte[64];
    for (int turn = 0; turn < turns; turn++) {
      script.at(turn);
      int connections = link.connections();
      int count = link.read(buffer);
      String bytes = new String(buffer, 0, count, US_ASCII);
      lines.add(turn + " " + link.isConnected() + " " + connections + " " + bytes);
      clock.advance(TICK_MICROS);
    }
    return lines;
  }

  private interface Script {
    void at(int turn);
  }

  private List<String> record() throws InterruptedException {
    LockstepClock clock = new LockstepClock();
    MemoryLink device = new MemoryLink();
    try (RecordingLink recorded = new RecordingLink(device, file, clock)) {
      return seen(
          recorded,
          clock,
          20,
          turn -> {
            if (turn % 2 == 0) {
              device.fromDevice(("turn " + turn).getBytes(US_ASCII));
            }
            if (turn == 7) {
              device.unplug();
            } else if (turn == 12) {
              device.plug();
            }
          });
    }
  }

  @Test
  void read_recordedRun_isPlayedTurnByTurn() throws Exception {
    List<String> first = record();
    LockstepClock clock = new LockstepClock();
    clock.advance(77_000_000);
    try (ReplayLink replay = new ReplayLink(file, clock, 1.0)) {
      List<String> second = seen(replay, clock, 17, turn -> {});

      assertThat(second).isEqualTo(first.subList(0, 17));
      assertThat(replay.write(new byte[1])).as("taken and forgotten").isTrue();
    }
  }

  @Test
  void read_recordingIsOver_deviceIsLost() throws Exception {
    record();
    LockstepClock clock = new LockstepClock();
    try (ReplayLink replay = new ReplayLink(file, clock, 1.0)) {
      seen(replay, clock, 25, turn -> {});

      assertThat(replay.isConnected()).isFalse();
      assertThat(replay.trouble()).isEqualTo("the recording has ended");
      assertThat(replay.write(new byte[1])).isFalse();
    }
  }

  @Test
  void read_tenTimesAsFast_takesATenthOfTheTime() throws Exception {
    record();
    LockstepClock clock = new LockstepClock();
    try (ReplayLink replay = new ReplayLink(file, clock, 10.0)) {
      List<String> lines = seen(replay, clock, 3, turn -> {});

      assertThat(lines.get(2)).isEqualTo("2 false 2 turn 14turn 16turn 18");
    }
  }

  @Test
  void open_noSuchFile_isRefused() {
    assertThatThrownBy(() -> new ReplayLink(file, new LockstepClock(), 1.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("recording " + file + " cannot be read");
  }

  @Test
  void open_noRecording_isRefusedWithTheLine() throws IOException {
    Files.writeString(file, "$GPGGA\n");
    assertThatThrownBy(() -> new ReplayLink(file, new LockstepClock(), 1.0))
        .hasMessage("recording " + file + ", line 1: expected \"# u2sa link recording 1\"");

    Files.writeString(file, RecordingLink.HEADER + "\n0 +\n10 < b5a\n");
    assertThatThrownBy(() -> new ReplayLink(file, new LockstepClock(), 1.0))
        .hasMessage(
            "recording "
                + file
                + ", line 3: \"10 < b5a\": expected MICROSECONDS, one of < > + -, and bytes in hexadecimal");
  }
}
