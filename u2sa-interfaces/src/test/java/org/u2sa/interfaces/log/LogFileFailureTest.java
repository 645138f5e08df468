package org.u2sa.interfaces.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.u2sa.interfaces.disk.DiskThread;

/** The service flies on when its log cannot. */
class LogFileFailureTest extends LogFileFixture {
  @Test
  @EnabledOnOs(OS.LINUX)
  void log_diskFull_countsEachLineAndSaysItOnce() throws IOException {
    try (LogFile log = log(Paths.get("/dev/full"), LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.INFO, "a");
      log.log(LogLevelEnum.ERROR, "b");

      assertThat(log.failures()).isEqualTo(2);
      assertThat(complaints())
          .isEqualTo(
              "/dev/full: log of Control cannot be written:"
                  + " java.io.IOException: No space left on device\n");
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void log_namedPipe_isNamedAndDoesNotWait() throws IOException, InterruptedException {
    Path pipe = folder.resolve("Control.log");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    try (LogFile log = log(pipe, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.INFO, "a");

      assertThat(log.failures()).isEqualTo(1);
      assertThat(complaints()).contains(pipe + " is a named pipe; remove it");
    }
  }

  @Test
  void log_folderCannotBeMade_countsAndRecoversWhenItCan() throws IOException {
    Path obstacle = Files.write(folder.resolve("logs"), new byte[0]);
    Path file = obstacle.resolve("Control.log");
    try (LogFile log = log(file, LogLevelEnum.INFO)) {
      log.log(LogLevelEnum.INFO, "a");
      log.log(LogLevelEnum.INFO, "b");
      assertThat(log.failures()).isEqualTo(2);
      assertThat(complaints()).startsWith(file + ": log of Control cannot be written: ");
      assertThat(complaints().split("\n")).hasSize(1);

      Files.delete(obstacle);
      log.log(LogLevelEnum.INFO, "c");
      log.log(LogLevelEnum.INFO, "d");
      assertThat(log.failures()).isEqualTo(2);
    }

    assertThat(text(file))
        .isEqualTo(
            line("WARN", "2 lines before this one could not be written")
                + line("INFO", "c")
                + line("INFO", "d"));
  }

  /** A file on a disk with the given free space [bytes]. */
  private static final class FillingDisk extends FilterOutputStream {
    private int free;

    FillingDisk(OutputStream out, int free) {
      super(out);
      this.free = free;
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      int taken = Math.min(free, bytes.length);
      out.write(bytes, 0, taken);
      free -= taken;
      if (taken < bytes.length) {
        throw new IOException("No space left on device");
      }
    }
  }

  @Test
  void log_diskFullsInTheMiddleOfALine_nextLineStartsAfresh() throws IOException {
    Path file = folder.resolve("Control.log");
    AtomicReference<FillingDisk> disk = new AtomicReference<>();
    LogFile.Opener opener =
        path -> {
          disk.set(new FillingDisk(new FileOutputStream(path.toFile(), true), 10));
          return disk.get();
        };
    try (LogFile log =
        new LogFile(
            file,
            "Control",
            LogLevelEnum.INFO,
            CLOCK,
            new PrintStream(complaints, true, "UTF-8"),
            opener,
            new DiskThread("test"),
            CLOCK)) {
      log.log(LogLevelEnum.INFO, "a");
      assertThat(log.failures()).isEqualTo(1);

      disk.get().free = 1000;
      log.log(LogLevelEnum.INFO, "b");
    }

    assertThat(text(file))
        .isEqualTo(
            "2017-07-14\n"
                + line("WARN", "1 line before this one could not be written")
                + line("INFO", "b"));
  }
}
