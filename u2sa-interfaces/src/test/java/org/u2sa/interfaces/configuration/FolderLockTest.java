package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The lock that writers of one folder's files take in turn. */
@Timeout(120)
class FolderLockTest {
  @TempDir Path folder;

  private Path file() {
    return folder.resolve(".configuration.lock");
  }

  @Test
  void close_lockThatWasTaken_isFreeForTheNext() throws IOException {
    FolderLock.take(folder).close();

    try (FileChannel other = FileChannel.open(file(), StandardOpenOption.WRITE);
        FileLock lock = other.tryLock()) {
      assertThat(lock).isNotNull();
    }
  }

  @Test
  void take_anotherWriterHoldsItAllTheTime_isRefused() throws IOException {
    FolderLock held = FolderLock.take(folder);

    assertThatThrownBy(() -> FolderLock.take(folder))
        .isInstanceOf(IOException.class)
        .hasMessage(file() + " is locked: another writer has held it for 2 s; try again");

    held.close();
    FolderLock.take(folder).close();
  }

  @Test
  void take_interruptedWhileAnotherHoldsIt_endsAtOnceAndStaysInterrupted() throws Exception {
    AtomicReference<String> said = new AtomicReference<>();
    Thread waiting =
        new Thread(
            () -> {
              try {
                FolderLock.take(folder).close();
              } catch (IOException e) {
                said.set(e.getMessage() + " " + Thread.currentThread().isInterrupted());
              }
            });
    FolderLock held = FolderLock.take(folder);
    waiting.start();
    while (waiting.isAlive()) {
      waiting.interrupt(); // until one comes while it waits
      waiting.join(1);
    }
    held.close();

    assertThat(said)
        .hasValue("interrupted while another writer was at work in " + folder + " true");
  }
}
