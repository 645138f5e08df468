package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;

/** A recorded link is as good as the link; its recording says what passed, and when. */
class RecordingLinkTest extends ByteLinkContract {
  @TempDir Path folder;

  @Override
  FarEnd device() {
    return FarEnds.recorded(folder.resolve("contract.rec"));
  }

  @Test
  void recording_whatPassed_isThereWithItsTimes() throws Exception {
    Path file = folder.resolve("own.rec");
    LockstepClock clock = new LockstepClock();
    clock.advance(5_000_000);
    MemoryLink memory = new MemoryLink();
    RecordingLink recorded = new RecordingLink(memory, file, clock);
    byte[] buffer = new byte[16];
    recorded.read(buffer);
    clock.advance(1_000);
    memory.fromDevice((byte) 0xB5, (byte) 0x62);
    recorded.read(buffer);
    recorded.write(new byte[] {0x01});
    clock.advance(1_000);
    memory.unplug();
    recorded.read(buffer);
    recorded.close();

    assertThat(file).hasContent(RecordingLink.HEADER + "\n0 +\n1000 < b562\n1000 > 01\n2000 -\n");
  }

  @Test
  void recording_folderIsNotThere_isRefused() {
    Path file = folder.resolve("no such folder").resolve("own.rec");

    assertThatThrownBy(() -> new RecordingLink(new MemoryLink(), file, new SystemClock()))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("recording " + file + " cannot be written");
    assertThat(Files.exists(file)).isFalse();
  }

  @Test
  void recording_fileExists_isNumberedAndTheOldOneStays() throws Exception {
    Path file = Files.writeString(folder.resolve("own.rec"), "before a crash");
    Files.writeString(folder.resolve("own-2.rec"), "and before another");

    new RecordingLink(new MemoryLink(), file, new SystemClock()).close();

    assertThat(file).hasContent("before a crash");
    assertThat(folder.resolve("own-3.rec")).content().startsWith(RecordingLink.HEADER);
  }

  @Test
  void recording_diskHangs_deviceDoesNotWaitAndItIsWrittenLater() throws Exception {
    Path file = folder.resolve("own.rec");
    CountDownLatch answers = new CountDownLatch(1);
    DiskThread.ofProcess().execute(() -> awaitAnswer(answers));
    MemoryLink memory = new MemoryLink();
    try (RecordingLink recorded = new RecordingLink(memory, file, new SystemClock())) {
      assertThat(recorded.write(new byte[] {0x01})).isTrue();
      assertThat(recorded.write(new byte[] {0x02})).isTrue();
      assertThat(file).hasContent(RecordingLink.HEADER + "\n");

      answers.countDown();
    } finally {
      answers.countDown();
    }

    assertThat(Files.readString(file))
        .matches(RecordingLink.HEADER + "\n(\\d+ \\+\n)?\\d+ > 01\n\\d+ > 02\n");
  }

  @Test
  void recording_diskHangsForLong_endsAndSaysWhy() {
    Path file = folder.resolve("own.rec");
    CountDownLatch answers = new CountDownLatch(1);
    DiskThread.ofProcess().execute(() -> awaitAnswer(answers));
    try (RecordingLink recorded = new RecordingLink(new MemoryLink(), file, new SystemClock())) {
      recorded.write(new byte[400_000]);
      assertThat(recorded.trouble()).isEmpty();
      assertThat(recorded.write(new byte[400_000])).isTrue();
      assertThat(recorded.trouble())
          .isEqualTo("recording " + file + " ended: the disk does not answer");

      answers.countDown();
    } finally {
      answers.countDown();
    }
  }

  private static void awaitAnswer(CountDownLatch answers) {
    try {
      answers.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
