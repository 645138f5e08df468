package org.u2sa.service;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.schema.MalformedMessageException;
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
  private static final String FIRST_WORDS = "U2SA progress 1";
  private static final String LAST_WORDS = "end";

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
    List<String> lines = new ArrayList<>();
    lines.add(String.join("\t", FIRST_WORDS, systemId, state.className()));
    state.values().forEach((name, value) -> lines.add(ProgressLine.of(name, value)));
    lines.add(LAST_WORDS);
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
    List<String> lines = Files.readAllLines(file, UTF_8);
    String[] first = lines.isEmpty() ? new String[0] : lines.get(0).split("\t", -1);
    int last = lines.size() - 1;
    if (first.length != 3 || !first[0].equals(FIRST_WORDS) || !lines.get(last).equals(LAST_WORDS)) {
      throw new IOException(file + ": not whole, or not the progress of a service");
    }
    if (!first[1].equals(systemId)) {
      throw new IOException(
          file + ", line 1: of system \"" + first[1] + "\", expected \"" + systemId + "\"");
    }
    HandOver state = new HandOver(first[2]);
    for (int i = 1; i < last; i++) {
      try {
        ProgressLine.readInto(state, lines.get(i), codec);
      } catch (MalformedMessageException | IllegalArgumentException e) {
        throw new IOException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
      }
    }
    return Optional.of(state);
  }

  /**
   * @throws IOException if it is there and cannot be deleted
   */
  void delete() throws IOException {
    Files.deleteIfExists(file);
  }
}
