package org.u2sa.interfaces.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class LogFileTest extends LogFileFixture {
  private Path file;

  @BeforeEach
  void name() {
    file = folder.resolve("Control.log");
  }

  private String logged(LogLevelEnum level, String message, Throwable thrown) throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(level, message, thrown);
    }
    return text(file);
  }

  @Test
  void log_newFolder_lineHasTimeLevelServiceThreadAndMessageAndIsWrittenAtOnce()
      throws IOException {
    file = folder.resolve("logs/Control.log");
    try (LogFile log = log(file, LogLevelEnum.DEBUG)) {
      log.log(LogLevelEnum.DEBUG, "bank {} é");

      assertThat(text(file)).isEqualTo(line("DEBUG", "bank {} é"));
    }
  }

  @Test
  void log_messageWithNewlines_isIndentedSoThatItForgesNoLine() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.WARN, "a\nb\r\nc\rd");
    }

    assertThat(text(file)).isEqualTo(line("WARN", "a\n    b\n    c\n    d"));
  }

  @Test
  void log_controlCharactersOfOthers_commandNoTerminal() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.WARN, "a\u001b]0;b\u0007c\u009b2Jd\u202ee\u2028f\tg");
    }

    assertThat(text(file)).isEqualTo(line("WARN", "a ]0;b c 2Jd e\n    f\tg"));
  }

  @Test
  void log_messageOfAMegabyte_isShortened() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.WARN, "x".repeat(1_000_000));
    }

    assertThat(text(file))
        .isEqualTo(line("WARN", "x".repeat(4_000) + "… (996000 more characters)"));
  }

  @Test
  void log_throwableWithAMessageOfAMegabyte_isShortened() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.WARN, "callback", new IllegalStateException("x".repeat(1_000_000)));
    }

    assertThat(text(file)).hasSizeLessThan(20_000).contains("more characters");
  }

  @Test
  void log_throwable_hasItsTraceBelow() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.ERROR, "callback", new IllegalStateException("no state"));
    }

    assertThat(text(file))
        .startsWith(
            line("ERROR", "callback")
                + "    java.lang.IllegalStateException: no state\n    \tat org.u2sa.interfaces.");
  }

  @Test
  void log_existingFile_isAppendedTo() throws IOException {
    Files.write(file, "before\n".getBytes());
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.INFO, "after");
    }

    assertThat(text(file)).isEqualTo("before\n" + line("INFO", "after"));
  }

  @Test
  void log_fileDeletedMeanwhile_isMadeAgain() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.INFO, "a");
      Files.delete(file);
      log.log(LogLevelEnum.INFO, "b");
    }

    assertThat(text(file)).isEqualTo(line("INFO", "b"));
  }

  @Test
  void log_eachLevel_isWrittenFromTheLowestUp() throws IOException {
    for (LogLevelEnum lowest : LogLevelEnum.values()) {
      file = folder.resolve(lowest + ".log");
      StringBuilder expected = new StringBuilder();
      try (LogFile log = log(file, lowest)) {
        for (LogLevelEnum level : LogLevelEnum.values()) {
          log.log(level, "x");
          assertThat(log.writes(level)).isEqualTo(level.ordinal() >= lowest.ordinal());
          expected.append(level.ordinal() >= lowest.ordinal() ? line(level.name(), "x") : "");
        }
      }
      assertThat(text(file)).isEqualTo(expected.toString());
    }
  }

  @Test
  void log_belowTheLevel_doesNotEvenAskForTheTime() {
    try (LogFile log = new LogFile(file, "Control", LogLevelEnum.INFO, clock(-1))) {
      assertThatCode(() -> log.log(LogLevelEnum.DEBUG, "x")).doesNotThrowAnyException();
    }
  }

  @Test
  void log_simulatedTime_startsAtZero() throws IOException {
    try (LogFile log = new LogFile(file, "Control", LogLevelEnum.INFO, clock(0))) {
      log.log(LogLevelEnum.INFO, "x");
    }

    assertThat(text(file)).startsWith("1970-01-01T00:00:00.000000Z | ");
  }

  @Test
  void log_manyLinesOfManyThreads_areAllThereWholeAndInTheirThreadsOrder() throws Exception {
    int threads = 4;
    int lines = 30_000;
    List<Callable<Boolean>> writers = new ArrayList<>();
    ExecutorService pool = Executors.newFixedThreadPool(threads);
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      for (int writer = 0; writer < threads; writer++) {
        String name = "writer " + writer + " line ";
        writers.add(
            () -> {
              for (int i = 0; i < lines; i++) {
                log.log(LogLevelEnum.INFO, name + i);
              }
              return true;
            });
      }
      for (Future<Boolean> done : pool.invokeAll(writers)) {
        assertThat(done.get()).isTrue();
      }
      assertThat(log.failures()).isZero();
    } finally {
      pool.shutdownNow();
    }

    int[] next = new int[threads];
    for (String line : Files.readAllLines(file)) {
      assertThat(line).matches(TIME + " \\| INFO \\| Control \\| \\d+ \\| writer \\d line \\d+");
      String[] words = line.substring(line.lastIndexOf('|') + 2).split(" ");
      int writer = Integer.parseInt(words[1]);
      assertThat(Integer.parseInt(words[3]))
          .as("line of writer %d", writer)
          .isEqualTo(next[writer]);
      next[writer]++;
    }
    assertThat(next).containsOnly(lines);
  }

  @Test
  void log_fileMovedAwayNowAndThen_everyLineIsInOneOfTheFiles() throws IOException {
    List<String> found = new ArrayList<>();
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      for (int i = 0; i < 5_000; i++) {
        if (i % 100 == 99) { // as a rotation from outside does
          Files.move(file, folder.resolve("Control.log." + i));
        }
        log.log(LogLevelEnum.INFO, "line " + i);
      }
      assertThat(log.failures()).isZero();
    }

    try (Stream<Path> files = Files.list(folder)) {
      for (Path each : files.toList()) {
        found.addAll(Files.readAllLines(each));
      }
    }
    assertThat(found).hasSize(5_000).doesNotHaveDuplicates();
  }

  @Test
  void log_interruptedThread_writes() throws IOException {
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      Thread.currentThread().interrupt();
      log.log(LogLevelEnum.INFO, "a");
      assertThat(Thread.interrupted()).isTrue();
      log.log(LogLevelEnum.INFO, "b");
      assertThat(log.failures()).isZero();
    }

    assertThat(text(file)).isEqualTo(line("INFO", "a") + line("INFO", "b"));
  }

  @Test
  void close_twiceAndThenLog_isHarmless() throws IOException {
    LogFile log = log(file, LogLevelEnum.INFO);
    log.close();
    log.close();
    log.log(LogLevelEnum.INFO, "late");

    assertThat(text(file)).isEmpty();
    assertThat(complaints()).isEmpty();
  }
}
