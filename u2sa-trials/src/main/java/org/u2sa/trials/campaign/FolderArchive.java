package org.u2sa.trials.campaign;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.ProtocolException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;

/** Packs folders into archives for transfer between hosts. */
public final class FolderArchive {
  /** Limit on the total unpacked size: a small archive can expand a thousandfold. */
  private static final long MAX_BYTES = 8L << 30;

  private static final int BLOCK_BYTES = 1 << 16;

  private FolderArchive() {}

  /** Packs all files of a folder; none if the folder does not exist. */
  static byte[] pack(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return new byte[0];
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      add(zip, "", folder);
    }
    return bytes.toByteArray();
  }

  /**
   * Adds all files of a folder.
   *
   * @param prefix prepended to their names, such as "config/"; may be empty
   */
  public static void add(ZipOutputStream zip, String prefix, Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> found = Files.walk(folder)) {
      files = found.filter(Files::isRegularFile).sorted().toList();
    }
    for (Path file : files) {
      String name = folder.relativize(file).toString().replace('\\', '/');
      zip.putNextEntry(new ZipEntry(prefix + name));
      Files.copy(file, zip);
      zip.closeEntry();
    }
  }

  /**
   * Unpacks an archive into a folder, creating it if needed.
   *
   * @throws ProtocolException if a file lies outside the folder, the files exceed 8 GiB, or the
   *     bytes are not an archive
   * @throws IOException if a file cannot be written
   */
  static void unpack(byte[] packed, Path folder) throws IOException {
    unpack(packed, folder, MAX_BYTES);
  }

  /**
   * @param maxBytes limit on the total size
   */
  static void unpack(byte[] packed, Path folder, long maxBytes) throws IOException {
    long left = maxBytes;
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(packed))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        Path file = folder.resolve(entry.getName()).normalize();
        if (!file.startsWith(folder.normalize())) {
          throw new ProtocolException("\"" + entry.getName() + "\" would lie outside " + folder);
        }
        Files.createDirectories(file.getParent());
        left = copy(zip, file, left);
      }
    } catch (ZipException | EOFException | IllegalArgumentException e) { // the last: bad name
      throw new ProtocolException("the files of a run cannot be unpacked: " + e.getMessage());
    }
  }

  /** Writes one entry; returns the bytes left of the limit. */
  private static long copy(ZipInputStream zip, Path file, long left) throws IOException {
    byte[] block = new byte[BLOCK_BYTES];
    long remaining = left;
    try (OutputStream out = Files.newOutputStream(file)) {
      for (int read = zip.read(block); read >= 0; read = zip.read(block)) {
        remaining -= read;
        if (remaining < 0) {
          throw new ProtocolException("the files of a run take more than is accepted: " + file);
        }
        out.write(block, 0, read);
      }
    }
    return remaining;
  }

  /** Deletes a folder recursively, if it exists. */
  static void delete(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }
}
