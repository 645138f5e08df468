package org.u2sa.interfaces.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.time.Clock;

/** A service does not wait for a disk that hangs. */
class LogFileHangTest extends LogFileFixture {
  private final CountDownLatch answers = new CountDownLatch(1);
  private final AtomicLong nowMicros = new AtomicLong(1_500_000_000_123_456L);
  private final DiskThread disk = new DiskThread("test");

  /** A file on a disk that hangs until it answers. */
  private final class HangingDisk extends FilterOutputStream {
    HangingDisk(OutputStream out) {
      super(out);
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      awaitAnswer();
      out.write(bytes);
    }
  }

  private final Clock realTime =
      new Clock() {
        @Override
        public long micros() {
          return nowMicros.get();
        }

        @Override
        public Waiter newWaiter(String name) {
          throw new UnsupportedOperationException("nobody waits in this test");
        }
      };

  private void awaitAnswer() {
    try {
      answers.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @AfterEach
  void letGo() {
    answers.countDown();
  }

  private LogFile log(LogFile.Opener opener) throws IOException {
    return new LogFile(
        folder.resolve("Control.log"),
        "Control",
        LogLevelEnum.INFO,
        realTime,
        new PrintStream(complaints, true, "UTF-8"),
        opener,
        disk,
        realTime);
  }

  private LogFile hangingLog() throws IOException {
    return log(path -> new HangingDisk(new FileOutputStream(path.toFile(), true)));
  }

  private String written() throws IOException {
    return text(folder.resolve("Control.log"));
  }

  @Test
  void log_diskHangsAtAWrite_returnsAndIsWrittenInOrderLater() throws IOException {
    try (LogFile log = hangingLog()) {
      log.log(LogLevelEnum.INFO, "a");
      log.log(LogLevelEnum.WARN, "b");
      assertThat(answers.getCount()).isOne();

      answers.countDown();
    }

    assertThat(written()).isEqualTo(line("INFO", "a") + line("WARN", "b"));
  }

  @Test
  void log_diskHangsAtTheOpening_returns() throws IOException {
    try (LogFile log =
        log(
            path -> {
              awaitAnswer();
              return new FileOutputStream(path.toFile(), true);
            })) {
      log.log(LogLevelEnum.INFO, "a");
      assertThat(answers.getCount()).isOne();

      answers.countDown();
    }

    assertThat(written()).isEqualTo(line("INFO", "a"));
  }

  private void awaitWritten(int lines) throws IOException {
    for (int k = 0; k <= lines / 64; k++) { // jobs of 64 lines each
      disk.call(() -> "done", 60_000);
    }
  }

  @Test
  void log_diskHangsForLong_dropsLinesAndSaysHowManyInTheNext() throws IOException {
    int kept = 0;
    try (LogFile log = hangingLog()) {
      while (log.failures() == 0) {
        log.log(LogLevelEnum.INFO, "x".repeat(3_000));
        kept++;
      }
      kept--; // the last one was dropped
      log.log(LogLevelEnum.INFO, "x".repeat(3_000));
      assertThat(log.failures()).isEqualTo(2);

      answers.countDown();
      awaitWritten(kept);
      log.log(LogLevelEnum.INFO, "last");
    }

    assertThat(kept).isBetween(100, 200);
    assertThat(written())
        .isEqualTo(
            line("INFO", "x".repeat(3_000)).repeat(kept)
                + line("WARN", "2 lines before this one could not be written")
                + line("INFO", "last"));
  }

  @Test
  void trouble_diskHangsForTwoSeconds_saysSo() throws IOException {
    try (LogFile log = hangingLog()) {
      log.log(LogLevelEnum.INFO, "a");
      nowMicros.addAndGet(2_000_000L);
      assertThat(log.trouble()).isEmpty();
      nowMicros.addAndGet(1L);
      assertThat(log.trouble()).isEqualTo("the disk does not answer; lines waiting: 1");

      answers.countDown();
    }
  }

  @Test
  void close_diskHangs_endsAndSaysThatLinesAreMissing() throws IOException {
    LogFile log = hangingLog();
    log.log(LogLevelEnum.INFO, "a");
    log.close();

    assertThat(answers.getCount()).isOne();
    assertThat(complaints()).contains("the last lines of Control are missing");
  }

  @Test
  void log_realTimeAndManyLines_writesAllInOrder() throws IOException {
    List<String> expected = new ArrayList<>();
    answers.countDown();
    try (LogFile log = hangingLog()) {
      for (int k = 0; k < 1_000; k++) {
        log.log(LogLevelEnum.INFO, "line " + k);
        expected.add(line("INFO", "line " + k).trim());
      }
      awaitWritten(1_000); // closing gives a busy machine only a second
      assertThat(log.failures()).isZero();
    }

    assertThat(Files.readAllLines(folder.resolve("Control.log"))).isEqualTo(expected);
  }

  @Test
  void log_realTimeAndForeignText_forgesNoLine() throws IOException {
    answers.countDown();
    try (LogFile log = hangingLog()) {
      log.log(LogLevelEnum.WARN, "a\nb\u001b]0;c");
    }

    assertThat(written()).isEqualTo(line("WARN", "a\n    b ]0;c"));
  }

  @Test
  void call_jobThatFails_throwsItsException() {
    Path absent = folder.resolve("absent");
    assertThatThrownBy(() -> disk.call(() -> Files.readAllBytes(absent), 60_000))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("absent");
  }
}
