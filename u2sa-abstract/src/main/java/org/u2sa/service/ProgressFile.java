package org.u2sa.service;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.schema.MessageCodec;

/**
 * What a service remembers for its restart: a text file beside its log, replaced as a whole, so
 * that a process that is killed in the middle leaves the one before. It is of one run: a service
 * that starts for the first time deletes what another run has left.
 *
 * <p>Not synced: it serves the restart of a service while its machine goes on, and after a power
 * cut the run is over.
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
   * @throws IOException if that failed: then the one before stands
   */
  void write(HandOver state) throws IOException {
    List<String> lines = HandOverText.lines(state, systemId);
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path beside = file.resolveSibling(file.getFileName() + ".tmp");
    Files.write(beside, lines, UTF_8);
    Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  /**
   * What was written last; empty if nothing was.
   *
   * @throws IOException if it cannot be read or is not what {@link #write} writes; says where
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
