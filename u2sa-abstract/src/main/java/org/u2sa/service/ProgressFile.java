package org.u2sa.service;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.interfaces.disk.ReplacedFile;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.handover.HandOverText;
import org.u2sa.service.handover.RememberedStates;

/**
 * Saved state of a service for its restart in this run: a text file in its log folder, replaced
 * atomically, and a copy in memory, so that a restart in this process does not depend on the disk.
 * Not synced, because a power cut ends the run. The service does not wait for a disk that hangs
 * ({@link ReplacedFile}).
 */
final class ProgressFile {
  private final Path file;
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
    codec = new MessageCodec(context.messageTypes());
    access = new ReplacedFile(context.clock());
  }

  Path path() {
    return file;
  }

  /**
   * @param failed called if writing fails, possibly later on another thread; the previous file is
   *     kept
   */
  void write(HandOver state, Consumer<IOException> failed) {
    inMemory.put(serviceName, state);
    List<String> lines = HandOverText.lines(state, systemId);
    access.change(() -> replace(lines), failed);
  }

  private void replace(List<String> lines) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path beside = file.resolveSibling(file.getFileName() + ".tmp");
    RegularFile.refusePipe(beside);
    Files.write(beside, lines, UTF_8);
    Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
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
    access.change(() -> Files.deleteIfExists(file), failed);
  }
}
