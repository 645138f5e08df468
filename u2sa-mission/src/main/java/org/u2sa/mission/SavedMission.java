package org.u2sa.mission;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.WholeFile;
import org.u2sa.interfaces.disk.ReplacedFile;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.handover.HandOverText;

/**
 * Mission progress saved in the log folder, so that another process can resume it. Replaced
 * atomically: a power cut leaves the old or the new file intact.
 */
final class SavedMission {
  private static final String DIGEST = "MISSION SHA-256";

  private final Path file;
  private final String writer;
  private final String systemId;
  private final MessageCodec codec;
  private final ReplacedFile access;

  /**
   * @param writer class of the saving service, as written in the file
   */
  SavedMission(ServiceContext context, String serviceName, String writer) {
    this.writer = writer;
    file = context.logDirectory().resolve(serviceName + ".mission");
    systemId = context.systemId();
    codec = new MessageCodec(context.messageTypes());
    access = new ReplacedFile(context.clock());
  }

  /**
   * Replaces the file.
   *
   * @param digest digest of the mission file as loaded, which must match for a resume
   * @param failed called if writing fails, possibly later on another thread; the previous file is
   *     kept
   */
  void write(MissionProgress progress, String digest, Consumer<IOException> failed) {
    HandOver state = new HandOver(writer).text(DIGEST, digest);
    progress.handOver(state);
    access.change(() -> replace(state), failed);
  }

  private void replace(HandOver state) throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    Files.createDirectories(folder);
    Path temporary = Files.createTempFile(folder, "." + file.getFileName(), ".tmp");
    try {
      WholeFile.fillAndRename(temporary, HandOverText.bytes(state, systemId), file);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  /**
   * Last saved progress; empty if none.
   *
   * @param mission name of the mission file
   * @param digest its digest
   * @throws IOException if it is unreadable, or saved for another mission or vehicle
   */
  Optional<MissionProgress> read(
      String mission, String digest, boolean loop, GoalSequence.Options options)
      throws IOException {
    HandOver state =
        access.read(() -> Files.exists(file) ? HandOverText.read(file, systemId, codec) : null);
    if (state == null) {
      return Optional.empty();
    }
    if (state.text(DIGEST).filter(digest::equals).isEmpty()) {
      throw new IOException(file + ": belongs to a different mission than " + mission + " is now");
    }
    try {
      Optional<MissionProgress> progress = MissionProgress.takenOver(state, loop, options);
      progress.ifPresent(MissionProgress::forgetFailsafe);
      return progress;
    } catch (IllegalArgumentException e) {
      throw new IOException(file + ": " + e.getMessage(), e);
    }
  }

  /** Deletes the file if it exists; may call {@code failed} later on another thread. */
  void delete(Consumer<IOException> failed) {
    access.change(() -> Files.deleteIfExists(file), failed);
  }

  /**
   * Digest of a mission file, to distinguish missions.
   *
   * @throws BadInputException if it cannot be read
   */
  static String digest(Path mission) {
    try {
      byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(mission));
      return String.format("%064x", new BigInteger(1, digest));
    } catch (IOException e) {
      throw new BadInputException(mission + ": " + e.getMessage(), e);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }
}
