package org.u2sa.interfaces;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LogFileTest {
  @TempDir Path folder;

  private static final Clock CLOCK =
      new Clock() {
        @Override
        public long micros() {
          return 1_500_000_000_123_456L;
        }

        @Override
        public Waiter newWaiter(String name) {
          throw new UnsupportedOperationException("nobody waits in this test");
        }
      };

  private static String text(Path file) throws IOException {
    return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
  }

  @Test
  void log_newFolder_lineHasTimeLevelServiceThreadAndMessage() throws IOException {
    Path file = folder.resolve("logs/Control.log");
    try (LogFile log = new LogFile(file, "Control", LogLevelEnum.INFO, CLOCK)) {
      log.log(LogLevelEnum.DEBUG, "unseen");
      log.log(LogLevelEnum.INFO, "bank 30 deg {} \r\nsecond");

      assertThat(text(file))
          .isEqualTo(
              "2017-07-14T02:40:00.123456Z | INFO | Control | "
                  + Thread.currentThread().getId()
                  + " | bank 30 deg {} \n    second\n");
    }
  }

  @Test
  void log_diskFull_countsAndDoesNotThrow() {
    try (LogFile log = new LogFile(Paths.get("/dev/full"), "Control", LogLevelEnum.INFO, CLOCK)) {
      log.log(LogLevelEnum.INFO, "a");
      log.log(LogLevelEnum.ERROR, "b");

      assertThat(log.failures()).isEqualTo(2);
    }
  }
}
