package org.u2sa.service;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.u2sa.interfaces.log.DiskWriter;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.handover.HandOverText;

/**
 * Saved state of a service for its restart: a text file beside its log, replaced atomically, so
 * that a process killed while writing leaves the previous file. Valid for one run: a service that
 * starts for the first time deletes the file of an earlier run.
 *
 * <p>Not synced to disk: it is for restarts of a service while the machine keeps running; a power
 * cut ends the run.
 *
 * <p>In real time the {@link DiskWriter} accesses it, so that the service does not wait for a disk
 * that hangs; of several states that wait for the disk, the last one is written.
 */
final class ProgressFile {
  private static final long READ_WITHIN_MS = 5_000;

  private final Path file;
  private final String systemId;
  private final MessageCodec codec;
  private final boolean writesAtOnce;
  private final AtomicReference<List<String>> waiting = new AtomicReference<>();

  ProgressFile(ServiceContext context, String serviceName) {
    file = context.logDirectory().resolve(serviceName + ".progress");
    systemId = context.systemId();
    codec = new MessageCodec(context.messageTypes());
    writesAtOnce = context.clock().isSimulated();
  }

  Path path() {
    return file;
  }

  /**
   * Replaces the file.
   *
   * @param failed called if writing fails, possibly later on another thread; the previous file is
   *     kept
   */
  void write(HandOver state, Consumer<IOException> failed) {
    List<String> lines = HandOverText.lines(state, systemId);
    if (writesAtOnce || waiting.getAndSet(lines) == null) {
      carryOut(() -> replace(writesAtOnce ? lines : waiting.getAndSet(null)), failed);
    }
  }

  private void replace(List<String> lines) throws IOException {
    if (lines == null) {
      return; // deleted meanwhile
    }
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path beside = file.resolveSibling(file.getFileName() + ".tmp");
    Files.write(beside, lines, UTF_8);
    Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  /**
   * Last saved state; empty if none. Waits for earlier writes in this process.
   *
   * @throws IOException if it is unreadable or malformed, naming the position, or the disk does not
   *     answer
   */
  Optional<HandOver> read() throws IOException {
    return writesAtOnce ? readNow() : DiskWriter.ofProcess().call(this::readNow, READ_WITHIN_MS);
  }

  private Optional<HandOver> readNow() throws IOException {
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    return Optional.of(HandOverText.read(file, systemId, codec));
  }

  /**
   * Deletes the file if it is there, and states that wait for the disk.
   *
   * @param failed called if that fails, possibly later on another thread
   */
  void delete(Consumer<IOException> failed) {
    waiting.set(null);
    carryOut(() -> Files.deleteIfExists(file), failed);
  }

  /** An access to the disk. */
  private interface Access {
    void make() throws IOException;
  }

  private void carryOut(Access access, Consumer<IOException> failed) {
    Runnable job =
        () -> {
          try {
            access.make();
          } catch (IOException e) {
            failed.accept(e);
          }
        };
    if (writesAtOnce) {
      job.run();
    } else {
      DiskWriter.ofProcess().execute(job);
    }
  }
}
