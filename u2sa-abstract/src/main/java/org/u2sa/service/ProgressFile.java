package org.u2sa.service;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
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
 */
final class ProgressFile {
  private final Path file;
  private final String systemId;
  private final MessageCodec codec;

  ProgressFile(ServiceContext context, String serviceName) {
    file = context.logDirectory().resolve(serviceName + ".progress");
    systemId = context.systemId();
    codec = new MessageCodec(context.messageTypes());
  }

  Path path() {
    return file;
  }

  /**
   * Replaces the file.
   *
   * @throws IOException if writing fails; the previous file is kept
   */
  void write(HandOver state) throws IOException {
    List<String> lines = HandOverText.lines(state, systemId);
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path beside = file.resolveSibling(file.getFileName() + ".tmp");
    Files.write(beside, lines, UTF_8);
    Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  /**
   * Last saved state; empty if none.
   *
   * @throws IOException if it is unreadable or malformed; names the position
   */
  Optional<HandOver> read() throws IOException {
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    return Optional.of(HandOverText.read(file, systemId, codec));
  }

  /**
   * @throws IOException if it is there and cannot be deleted
   */
  void delete() throws IOException {
    Files.deleteIfExists(file);
  }
}
