package org.u2sa.cli.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.playback.Playback;
import org.u2sa.recorder.playback.RecordedSpan;

/** A recording of 100 s, a message each second, on a clock that goes on only where one waits. */
@Timeout(60)
class PlaybackTest {
  private static final long SECOND = 1_000_000_000L;
  private static final int SECONDS = 100;

  @TempDir private Path directory;
  private final JumpingClock clock = new JumpingClock();
  private final List<Integer> played = new ArrayList<>();
  private final List<Double> playedAtS = new ArrayList<>();
  private final List<Playback.Position> told = new ArrayList<>();
  private final List<Long> sought = new ArrayList<>();
  private McapReader reader;

  @BeforeEach
  void write() throws IOException {
    Path file = directory.resolve("seconds.mcap");
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      writer.add(new McapSchema(1, "Second", "", new byte[0]));
      writer.add(new McapChannel(1, 1, "seconds", "none", Map.of()));
      for (int i = 0; i <= SECONDS; i++) {
        writer.add(new McapMessage(1, i, i * SECOND, i * SECOND, new byte[] {(byte) i}));
      }
    }
    reader = McapReader.open(file);
  }

  @AfterEach
  void close() throws IOException {
    reader.close();
  }

  private Playback playback(double fromS, double toS, double rate, boolean loops) {
    RecordedSpan span = new RecordedSpan(0, (long) (fromS * SECOND), (long) (toS * SECOND));
    return new Playback(reader, channel -> true, span, rate, loops, clock);
  }

  /** Plays; {@code then} is told each second that was played. */
  private void play(Playback playback, IntConsumer then) throws Exception {
    long began = clock.micros();
    playback.play(
        new Playback.Sink() {
          @Override
          public void play(McapMessage message) {
            played.add((int) message.data()[0]);
            playedAtS.add(Clock.seconds(clock.micros() - began));
            then.accept(message.data()[0]);
          }

          @Override
          public void at(Playback.Position position) {
            told.add(position);
          }

          @Override
          public void sought(long nanos) {
            sought.add(nanos);
          }
        },
        () -> clock.micros() - began > Clock.micros(1_000.0));
  }

  private static void press(Playback playback, String keys) {
    PlaybackKeys.read(new ByteArrayInputStream(keys.getBytes(StandardCharsets.US_ASCII)), playback);
  }

  @Test
  void play_spanAtTwiceTheRate_playsWhatIsInItInHalfTheTime() throws Exception {
    play(playback(9.5, 14.0, 2.0, false), second -> {});
    assertThat(played).containsExactly(10, 11, 12, 13, 14);
    assertThat(playedAtS.get(0)).isCloseTo(0.25, within(1e-6));
    assertThat(playedAtS.get(4)).isCloseTo(2.25, within(1e-6));
  }

  @Test
  void play_positions_goOnBetweenMessages() throws Exception {
    play(playback(0.0, 2.0, 1.0, false), second -> {});
    assertThat(told)
        .extracting(position -> Math.round(position.nanos() / 1e7))
        .contains(0L, 50L, 100L, 150L, 200L)
        .isSorted();
  }

  @Test
  void keys_rightAndLeft_goFiveSecondsOnAndBack() throws Exception {
    Playback playback = playback(0.0, 100.0, 1.0, false);
    play(
        playback,
        second -> {
          if (played.size() == 3) {
            press(playback, "\u001b[C\u001b[C"); // from 2 s to 12 s
          } else if (played.size() == 5) {
            press(playback, "\u001b[D"); // from 13 s to 8 s
          } else if (played.size() == 6) {
            press(playback, "q");
          }
        });
    assertThat(played).containsExactly(0, 1, 2, 12, 13, 8);
  }

  @Test
  void keys_seekBeyondTheEnds_staysWithinTheSpan() throws Exception {
    Playback playback = playback(10.0, 12.0, 1.0, false);
    play(
        playback,
        second -> {
          if (played.size() == 1) {
            press(playback, "\u001b[D");
          } else if (played.size() == 2) {
            press(playback, "\u001b[C");
          }
        });
    assertThat(played).containsExactly(10, 10, 12);
  }

  @Test
  void keys_pauseAndStep_playOneMessageEach() throws Exception {
    Playback playback = playback(0.0, 100.0, 1.0, false);
    List<Integer> playedWhilePaused = new ArrayList<>();
    long[] pausedAt = new long[1];
    clock.onWait(
        () -> {
          if (played.size() == 3 && pausedAt[0] == 0) {
            pausedAt[0] = clock.micros();
            press(playback, " ");
          } else if (pausedAt[0] > 0 && clock.micros() - pausedAt[0] > Clock.micros(30.0)) {
            playedWhilePaused.addAll(played);
            pausedAt[0] = Long.MAX_VALUE;
            press(playback, "s");
          } else if (played.size() == 4) {
            press(playback, "q");
          }
        });
    play(playback, second -> {});
    assertThat(playedWhilePaused).containsExactly(0, 1, 2);
    assertThat(played).containsExactly(0, 1, 2, 3);
    assertThat(told.get(told.size() - 1).isPaused()).isTrue();
  }

  @Test
  void keys_upTwice_playsFourTimesAsFast() throws Exception {
    Playback playback = playback(0.0, 8.0, 1.0, false);
    play(
        playback,
        second -> {
          if (second == 0) {
            press(playback, "\u001b[A\u001b[A");
          }
        });
    assertThat(playedAtS.get(8)).isCloseTo(2.0, within(1e-6));
  }

  @Test
  void play_loop_beginsAnewUntilItIsOver() throws Exception {
    Playback playback = playback(98.0, 100.0, 1.0, true);
    play(
        playback,
        second -> {
          if (played.size() == 7) {
            playback.end();
          }
        });
    assertThat(played).containsExactly(98, 99, 100, 98, 99, 100, 98);
  }

  @Test
  void holdAtEnd_thenSeekTo_playsOnFromThere() throws Exception {
    Playback playback = playback(98.0, 100.0, 1.0, false);
    playback.holdAtEnd();
    clock.onWait(
        () -> {
          boolean isHeld = !told.isEmpty() && told.get(told.size() - 1).isPaused();
          if (isHeld && played.size() == 3) {
            playback.seekTo(99 * SECOND);
            playback.rate(4.0);
            playback.pause(false);
          } else if (isHeld && played.size() == 5) {
            playback.end();
          }
        });
    play(playback, second -> {});
    assertThat(played).containsExactly(98, 99, 100, 99, 100);
    assertThat(playedAtS.get(4) - playedAtS.get(3)).isCloseTo(0.25, within(1e-6));
    assertThat(sought).containsExactly(98 * SECOND, 99 * SECOND);
  }

  @Test
  void play_loopOverNothing_ends() throws Exception {
    play(playback(0.2, 0.8, 1.0, true), second -> {});
    assertThat(played).isEmpty();
  }

  /** Goes on to the deadline of each wait at once. */
  private static final class JumpingClock implements Clock {
    private long micros = 1_000_000_000L;
    private Runnable onWait = () -> {};

    void onWait(Runnable action) {
      onWait = action;
    }

    @Override
    public long micros() {
      return micros;
    }

    @Override
    public Waiter newWaiter(String name) {
      return new Waiter() {
        @Override
        public void await(long deadlineMicros) {
          onWait.run();
          micros = Math.max(micros, deadlineMicros);
        }

        @Override
        public void signal() {
          throw new IllegalStateException("nobody signals a playback");
        }

        @Override
        public void close() {
          // nothing is held
        }
      };
    }
  }
}
