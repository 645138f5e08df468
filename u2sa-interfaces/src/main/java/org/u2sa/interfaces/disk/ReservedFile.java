package org.u2sa.interfaces.disk;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;

/**
 * A text file that can still be replaced when the disk is full, within room that is reserved for it
 * beforehand in a second file. The text may then end with empty lines, which keep the room. Not
 * thread-safe.
 *
 * <p>On a file system that writes changed blocks elsewhere (btrfs, ZFS), the room does not help.
 */
public final class ReservedFile {
  private static final byte FILLER = '\n';
  private static final byte UNDER_WAY = '#'; // first byte of a file that is being overwritten
  private static final int GROWTH = 2; // of a text, for which room is kept

  private final Path file;
  private final Path beside;
  private final Path reserve;
  private final int leastRoom;

  /**
   * @param leastRoom bytes to reserve at least; 0: reserve nothing
   */
  public ReservedFile(Path file, int leastRoom) {
    this.file = file;
    beside = file.resolveSibling(file.getFileName() + ".tmp");
    reserve = file.resolveSibling(file.getFileName() + ".reserve");
    this.leastRoom = leastRoom;
  }

  /**
   * Replaces the file atomically. On a full disk the reserve replaces it; if that is used up, the
   * file is overwritten, and is invalid while that lasts.
   *
   * @param text not empty, nor beginning with #
   * @throws IOException if there is no room even so; no file is left then
   */
  public void replace(byte[] text) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    RegularFile.refusePipe(beside);
    RegularFile.refusePipe(reserve);
    try {
      Files.write(beside, text);
      rename(beside);
    } catch (IOException e) {
      discard(beside, e);
      replaceWithoutRoom(text, e);
      return;
    }
    reserve(text.length);
  }

  private void rename(Path other) throws IOException {
    Files.move(other, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  private void replaceWithoutRoom(byte[] text, IOException why) throws IOException {
    try {
      if (Files.exists(reserve) && Files.size(reserve) >= text.length) {
        overwrite(reserve, text);
        rename(reserve);
        return;
      }
    } catch (IOException e) {
      why.addSuppressed(e);
    }
    try {
      overwrite(file, text);
    } catch (IOException e) {
      why.addSuppressed(e);
      discard(file, why);
      throw why;
    }
  }

  /** Overwrites a file up to its end, so that it keeps its blocks. */
  private static void overwrite(Path path, byte[] text) throws IOException {
    try (FileChannel channel = FileChannel.open(path, StandardOpenOption.WRITE)) {
      int size = (int) Math.min(Integer.MAX_VALUE, Math.max(channel.size(), text.length));
      byte[] whole = Arrays.copyOf(text, size);
      Arrays.fill(whole, text.length, size, FILLER);
      write(channel, 0, new byte[] {UNDER_WAY}, 0);
      write(channel, 1, whole, 1);
      write(channel, 0, new byte[] {text[0]}, 0);
    }
  }

  private static void write(FileChannel channel, long at, byte[] bytes, int from)
      throws IOException {
    channel.position(at);
    ByteBuffer rest = ByteBuffer.wrap(bytes, from, bytes.length - from);
    while (rest.hasRemaining()) {
      channel.write(rest);
    }
  }

  /** Reserves room, as far as the disk has any; the file has been replaced without it. */
  private void reserve(int length) {
    int room = Math.max(leastRoom, GROWTH * length);
    try {
      long reserved = Files.exists(reserve) ? Files.size(reserve) : 0L;
      if (leastRoom > 0 && reserved < room) {
        byte[] more = new byte[(int) (room - reserved)];
        Arrays.fill(more, FILLER);
        Files.write(reserve, more, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      }
    } catch (IOException e) {
      // the file itself is saved, and what could be reserved counts; the next change tries again
    }
  }

  private static void discard(Path path, IOException why) {
    try {
      Files.deleteIfExists(path);
    } catch (IOException e) {
      why.addSuppressed(e);
    }
  }

  /** Deletes the file and its reserve. */
  public void delete() throws IOException {
    Files.deleteIfExists(file);
    Files.deleteIfExists(reserve);
  }
}
