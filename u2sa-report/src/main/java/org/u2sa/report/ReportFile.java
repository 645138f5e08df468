package org.u2sa.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.recorder.mcap.record.Opcode;

/**
 * Writes a file atomically: to a temporary file in the same folder, renamed when complete. Never
 * replaces a recording, which a mistyped command would otherwise lose.
 */
public final class ReportFile {

  /** Writes a file's bytes. */
  @FunctionalInterface
  public interface Bytes {
    void writeTo(OutputStream out) throws IOException;
  }

  /** Writes a file's text. */
  @FunctionalInterface
  public interface Text {
    void writeTo(Writer out) throws IOException;
  }

  private ReportFile() {}

  /**
   * Writes UTF-8.
   *
   * @throws RunFailedException if it cannot be written; leaves nothing behind
   * @throws BadInputException if the file is a recording
   */
  public static void writeText(Path file, Text content) {
    write(
        file,
        out -> {
          Writer writer = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
          content.writeTo(writer);
          writer.flush();
        });
  }

  /**
   * @throws RunFailedException if it cannot be written; leaves nothing behind
   * @throws BadInputException if the file is a recording
   */
  public static void write(Path file, Bytes content) {
    refuse(file, isMcap(file));
    Path temporary = file.resolveSibling("." + file.getFileName() + ".part");
    try {
      try (OutputStream out = newOutputStream(temporary)) {
        content.writeTo(out);
      }
      Files.move(
          temporary, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } catch (IOException e) {
      throw notWritten(file, discard(temporary, e));
    }
  }

  /**
   * Opens a file for writing in place of one of that name, or of a link: in a shared folder it may
   * be somebody else's, and lead to a file of this account.
   */
  public static OutputStream newOutputStream(Path file) throws IOException {
    Files.deleteIfExists(file);
    return Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /** Error for a file that cannot be written. */
  public static RunFailedException notWritten(Path file, IOException e) {
    return new RunFailedException("cannot write " + file + ": " + reason(e), e);
  }

  /**
   * Refuses to overwrite a recording.
   *
   * @throws BadInputException if the file is a recording
   */
  public static void refuse(Path file, boolean isRecording) {
    if (isRecording) {
      throw new BadInputException(file + " is a recording; expected another file to write to");
    }
  }

  /** Whether the file exists and begins like a recording or an export for viewers. */
  public static boolean isMcap(Path file) {
    if (!Files.isRegularFile(file)) {
      return false;
    }
    byte[] magic = Opcode.magic();
    try (InputStream in = Files.newInputStream(file)) {
      return Arrays.equals(in.readNBytes(magic.length), magic);
    } catch (IOException e) {
      throw new RunFailedException("cannot determine what " + file + " is: " + reason(e), e);
    }
  }

  /**
   * Returns the operating system's reason; java.nio exceptions whose message is only a path get an
   * explanation.
   */
  public static String reason(IOException e) {
    if (e instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (e instanceof NoSuchFileException) {
      return "its directory does not exist";
    }
    if (e instanceof FileAlreadyExistsException) {
      return "a file of that name already exists";
    }
    return e.getMessage();
  }

  private static IOException discard(Path temporary, IOException first) {
    try {
      Files.deleteIfExists(temporary);
    } catch (IOException second) {
      first.addSuppressed(second);
    }
    return first;
  }
}
