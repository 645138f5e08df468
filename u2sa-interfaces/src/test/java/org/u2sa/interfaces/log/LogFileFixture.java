package org.u2sa.interfaces.log;

import java.io.ByteArrayOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.time.Clock;

/**
 * What tests of log files have in common: a folder, a clock that stands, and what is said on
 * stderr.
 */
abstract class LogFileFixture {
  static final String TIME = "2017-07-14T02:40:00.123456Z";
  static final Clock CLOCK = clock(1_500_000_000_123_456L);

  @TempDir Path folder;
  final ByteArrayOutputStream complaints = new ByteArrayOutputStream();

  static Clock clock(long micros) {
    return new Clock() {
      @Override
      public long micros() {
        if (micros < 0) {
          throw new IllegalStateException("nobody should ask for the time");
        }
        return micros;
      }

      @Override
      public boolean isSimulated() {
        return true;
      }

      @Override
      public Waiter newWaiter(String name) {
        throw new UnsupportedOperationException("nobody waits in this test");
      }
    };
  }

  final LogFile log(Path file, LogLevelEnum lowest) throws IOException {
    return new LogFile(
        file,
        "Control",
        lowest,
        CLOCK,
        new PrintStream(complaints, true, "UTF-8"),
        path -> new FileOutputStream(path.toFile(), true),
        new DiskThread("test"),
        CLOCK);
  }

  final String complaints() throws IOException {
    return complaints.toString("UTF-8");
  }

  static String text(Path file) throws IOException {
    return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
  }

  static String line(String level, String message) {
    long thread = Thread.currentThread().getId();
    return TIME + " | " + level + " | Control | " + thread + " | " + message + "\n";
  }
}
