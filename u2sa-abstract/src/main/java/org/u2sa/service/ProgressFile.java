package org.u2sa.service;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
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
 * On a full disk the file is overwritten in place, which needs no room, or else deleted: a
 * successor must not take an old state for the present one. Not synced, because a power cut ends
 * the run. The service does not wait for a disk that hangs ({@link ReplacedFile}).
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
   * @param saved called once it is written, possibly later on another thread
   * @param failed likewise if that fails; no file is left
   */
  void write(HandOver state, Runnable saved, Consumer<IOException> failed) {
    inMemory.put(serviceName, state);
    byte[] text = (String.join("\n", HandOverText.lines(state, systemId)) + "\n").getBytes(UTF_8);
    access.change(
        () -> {
          save(text);
          saved.run();
        },
        failed);
  }

  private void save(byte[] text) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path beside = file.resolveSibling(file.getFileName() + ".tmp");
    RegularFile.refusePipe(beside);
    try {
      Files.write(beside, text);
      Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      discard(beside, e);
      overwrite(text, e);
    }
  }

  private static void discard(Path path, IOException why) {
    try {
      Files.deleteIfExists(path);
    } catch (IOException e) {
      why.addSuppressed(e);
    }
  }

  private void overwrite(byte[] text, IOException why) throws IOException {
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
      ByteBuffer rest = ByteBuffer.wrap(text);
      while (rest.hasRemaining()) {
        channel.write(rest);
      }
      channel.truncate(text.length);
    } catch (IOException e) {
      why.addSuppressed(e);
      discard(file, why);
      throw why;
    }
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
