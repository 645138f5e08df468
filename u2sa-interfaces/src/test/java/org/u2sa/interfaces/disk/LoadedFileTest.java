package org.u2sa.interfaces.disk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;

/** A file on a disk that hangs, and one that changes. */
@Timeout(120)
class LoadedFileTest {
  private static final String CHANGED =
      ": was changed after it was loaded; the loaded values stay in force until the service is"
          + " restarted";

  @TempDir private Path folder;
  private final CountDownLatch answers = new CountDownLatch(1);
  private final AtomicLong nowMicros = new AtomicLong(1_000);
  private volatile boolean hangs;
  private Path path;
  private final Clock stopwatch = clock(nowMicros::get);
  private final Clock clock =
      clock(
          () -> {
            throw new AssertionError("a repeated execution would read it at another time");
          });

  private static Clock clock(LongSupplier micros) {
    return new Clock() {
      @Override
      public long micros() {
        return micros.getAsLong();
      }

      @Override
      public Waiter newWaiter(String name) {
        throw new UnsupportedOperationException();
      }
    };
  }

  @BeforeEach
  void write() throws IOException {
    path = Files.writeString(folder.resolve("fence.xml"), "old");
  }

  @AfterEach
  void letTheDiskAnswer() {
    answers.countDown();
  }

  private String read(Path file) {
    try {
      if (hangs) {
        answers.await();
      }
      return Files.readString(file);
    } catch (IOException e) {
      throw new BadInputException(file + ": unreadable", e);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  /** What a look that begins now finds: jobs of the disk's thread run in order. */
  private Optional<String> found(LoadedFile<String> file) {
    LoadedFile.read(path, each -> "an earlier look has ended", clock);
    file.fault();
    LoadedFile.read(path, each -> "this look has ended", clock);
    return file.fault();
  }

  @Test
  void fault_diskHangs_keepsTheLastFindingThenSaysSoAndDoesNotWait() throws IOException {
    LoadedFile<String> file = new LoadedFile<>(path, this::read, clock, stopwatch);
    hangs = true;
    Files.writeString(path, "changed");

    assertThat(file.fault()).isEmpty();
    nowMicros.addAndGet(5 * Clock.MICROS_PER_SECOND);
    assertThat(file.fault()).isEmpty();
    nowMicros.incrementAndGet();
    assertThat(file.fault())
        .contains(path + ": a disk does not answer; the loaded values stay in force");

    answers.countDown();
    assertThat(found(file)).contains(path + CHANGED);
    assertThat(file.content()).isEqualTo("old");
  }

  @Test
  void fault_fileDeletedAndRestoredLater_isFoundByTheNextLooks() throws IOException {
    LoadedFile<String> file = new LoadedFile<>(path, this::read, clock, stopwatch);
    Path away = Files.move(path, folder.resolve("away.xml"));
    assertThat(found(file))
        .contains(path + ": unreadable; the previously loaded values stay in force");

    Files.move(away, path);
    assertThat(found(file)).isEmpty();
  }

  @Test
  void fault_inSimulatedTime_isFoundAtOnce() throws IOException {
    LoadedFile<String> file = new LoadedFile<>(path, this::read, new LockstepClock());
    Files.writeString(path, "changed");

    assertThat(file.fault()).contains(path + CHANGED);
  }

  @Test
  void read_diskHangs_failsAfterAWhile() {
    hangs = true;

    assertThatThrownBy(() -> LoadedFile.read(path, this::read, clock))
        .isInstanceOf(BadInputException.class)
        .hasMessage(path + ": the disk did not answer within 1000 ms");
  }
}
