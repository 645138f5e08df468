package org.u2sa.interfaces.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.time.SystemClock;

/** Logs when the system has no thread or no memory left. */
@Timeout(120)
class DiskThreadTest extends LogFileFixture {
  private static final long WITHIN_MS = 60_000;

  private final AtomicBoolean isShort = new AtomicBoolean();
  private final AtomicInteger started = new AtomicInteger();
  private final List<String> done = Collections.synchronizedList(new ArrayList<>());

  private Thread made(Runnable job) {
    return new Thread(job) {
      @Override
      public void start() {
        if (isShort.get()) {
          throw new OutOfMemoryError("unable to create native thread");
        }
        started.incrementAndGet();
        setUncaughtExceptionHandler((thread, failure) -> done.add(failure.getMessage()));
        super.start();
      }
    };
  }

  private LogFile log(DiskThread disk, LogFile.Opener opener) throws IOException {
    return new LogFile(
        folder.resolve("Control.log"),
        "Control",
        LogLevelEnum.INFO,
        new SystemClock(),
        new PrintStream(complaints, true, "UTF-8"),
        opener,
        disk,
        new SystemClock());
  }

  private static OutputStream file(Path path) throws IOException {
    return new FileOutputStream(path.toFile(), true);
  }

  @Test
  void execute_noThreadLeft_runsTheJobsInOrderOnceThereIsOne() throws IOException {
    isShort.set(true);
    DiskThread disk = new DiskThread(this::made);
    disk.execute(() -> done.add("a"));
    isShort.set(false);

    assertThat(disk.<List<String>>call(() -> List.copyOf(done), WITHIN_MS)).containsExactly("a");
  }

  @Test
  void execute_threadsRunOutLater_keepsTheThreadItHas() throws IOException {
    DiskThread disk = new DiskThread(this::made);
    isShort.set(true);
    disk.execute(
        () -> {
          throw new OutOfMemoryError("heap");
        });
    disk.execute(() -> done.add("next"));

    assertThat(disk.<List<String>>call(() -> List.copyOf(done), WITHIN_MS))
        .containsExactly("heap", "next");
    assertThat(started).hasValue(1);
  }

  @Test
  void log_noThreadLeft_returnsAndWritesTheLineLater() throws IOException {
    isShort.set(true);
    try (LogFile log = log(new DiskThread(this::made), DiskThreadTest::file)) {
      log.log(LogLevelEnum.INFO, "a");
      isShort.set(false);
      log.log(LogLevelEnum.INFO, "b");
    }

    assertThat(text(folder.resolve("Control.log"))).containsSubsequence("| a\n", "| b\n");
    assertThat(complaints()).isEmpty();
  }

  @Test
  void log_writeFailsForLackOfMemory_countsTheLineAndWritesTheNext() throws IOException {
    AtomicBoolean isFull = new AtomicBoolean(true);
    LogFile.Opener opener =
        path ->
            new FilterOutputStream(file(path)) {
              @Override
              public void write(byte[] bytes) throws IOException {
                if (isFull.getAndSet(false)) {
                  throw new OutOfMemoryError("heap");
                }
                out.write(bytes);
              }
            };
    try (LogFile log = log(new DiskThread(this::made), opener)) {
      log.log(LogLevelEnum.INFO, "a");
      log.log(LogLevelEnum.INFO, "b");
    }

    assertThat(text(folder.resolve("Control.log")))
        .doesNotContain("| a\n")
        .containsSubsequence("1 line before this one could not be written", "| b\n");
  }
}
