package org.u2sa.scenarios.campaign;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;

/** Folders as one piece: for the way between hosts. */
public final class FolderArchive {
  private FolderArchive() {}

  /** All files of a folder; none if there is no such folder. */
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
   * @param prefix goes before their names, such as "config/"; may be empty
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
   * Writes packed files into a folder, which is made if need be.
   *
   * @throws IOException if one cannot be written, or lies outside the folder
   */
  static void unpack(byte[] packed, Path folder) throws IOException {
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(packed))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        Path file = folder.resolve(entry.getName()).normalize();
        if (!file.startsWith(folder.normalize())) {
          throw new IOException("\"" + entry.getName() + "\" would lie outside " + folder);
        }
        Files.createDirectories(file.getParent());
        Files.write(file, zip.readAllBytes());
      }
    }
  }

  /** Deletes a folder and what is in it, if it exists. */
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
