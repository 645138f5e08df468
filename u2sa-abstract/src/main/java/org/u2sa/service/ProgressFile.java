package org.u2sa.service;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.interfaces.disk.ReplacedFile;
import org.u2sa.interfaces.disk.ReservedFile;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.handover.HandOverText;
import org.u2sa.service.handover.RememberedStates;

/**
 * Saved state of a service for its restart in this run: a text file in its log folder, replaced
 * atomically, and a copy in memory, so that a restart in this process does not depend on the disk.
 * In real time, room is reserved for a full disk ({@link ReservedFile}). If that is not enough, the
 * file is deleted: a successor must not take an old state for the present one. Not synced, because
 * a power cut ends the run. The service does not wait for a disk that hangs ({@link ReplacedFile}).
 */
final class ProgressFile {
  private static final int RESERVED_BYTES = 256 * 1024; // a fence as long as may be, 64 answers

  private final Path file;
  private final ReservedFile saving; // accessed by the thread that writes
  private final String serviceName;
  private final String systemId;
  private final MessageCodec codec;
  private final ReplacedFile access;
  private final RememberedStates inMemory;

  ProgressFile(ServiceContext context, String serviceName) {
    this.serviceName = serviceName;
    inMemory = context.remembered();
    file = context.logDirectory().resolve(serviceName + ".progress");
    systemId = context.systemId();
    saving = new ReservedFile(file, context.clock().isSimulated() ? 0 : RESERVED_BYTES);
    codec = new MessageCodec(context.messageTypes());
    access = new ReplacedFile(context.clock());
  }

  Path path() {
    return file;
  }

  /**
   * @param saved called once it is written, possibly later on another thread
   * @param failed likewise if that fails; no file is left
   */
  void write(HandOver state, Runnable saved, Consumer<IOException> failed) {
    inMemory.put(serviceName, state);
    byte[] text = HandOverText.bytes(state, systemId);
    access.change(
        () -> {
          saving.replace(text);
          saved.run();
        },
        failed);
  }

  /**
   * Last saved state; empty if none.
   *
   * @throws IOException if it is unreadable or malformed, naming the position, or the disk does not
   *     answer
   */
  Optional<HandOver> read() throws IOException {
    Optional<HandOver> kept = inMemory.get(serviceName);
    if (kept.isPresent()) {
      return kept;
    }
    return access.read(
        () ->
            Files.exists(file)
                ? Optional.of(HandOverText.read(file, systemId, codec))
                : Optional.empty());
  }

  /**
   * Deletes the saved state.
   *
   * @param failed called if that fails, possibly later on another thread
   */
  void delete(Consumer<IOException> failed) {
    inMemory.remove(serviceName);
    access.change(saving::delete, failed);
  }
}
