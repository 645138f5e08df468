package org.u2sa.spark;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.jar.JarOutputStream;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.u2sa.trials.campaign.FolderArchive;

/**
 * Archive of this program for other hosts: every class path entry, numbered in order, under {@value
 * #LIBRARIES}, plus the files that demos read.
 */
final class ProgramArchive {
  /** Folder of the class path in the archive. */
  static final String LIBRARIES = "lib";

  private static final List<String> DATA = List.of("config", "missions");

  private ProgramArchive() {}

  /** Archives the class path, and config and missions of {@code home} if present. */
  static void write(Path archive, String classPath, Path home) throws IOException {
    try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive))) {
      zip.setLevel(Deflater.BEST_SPEED); // mostly jars, which are already compressed
      int number = 0;
      for (String text : classPath.split(File.pathSeparator)) {
        Path entry = Path.of(text);
        String name =
            String.format(Locale.ROOT, "%s/%03d-%s", LIBRARIES, number++, entry.getFileName());
        if (Files.isDirectory(entry)) {
          FolderArchive.add(zip, name + "/", entry);
        } else if (Files.isRegularFile(entry)) {
          zip.putNextEntry(new ZipEntry(name));
          Files.copy(entry, zip);
          zip.closeEntry();
        }
      }
      for (String folder : DATA) {
        if (Files.isDirectory(home.resolve(folder))) {
          FolderArchive.add(zip, folder + "/", home.resolve(folder));
        }
      }
    }
  }

  /**
   * The jar containing a class, or a newly created jar if the class is in a folder, as in an IDE or
   * a test.
   *
   * @param scratch temporary folder for the new jar
   */
  static Path jarOf(Class<?> type, Path scratch) throws IOException {
    Path source;
    try {
      source = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IOException("the origin of " + type.getName() + " is not a file: " + e, e);
    }
    if (!Files.isDirectory(source)) {
      return source;
    }
    Path jar = scratch.resolve(type.getSimpleName() + ".jar");
    try (ZipOutputStream zip = new JarOutputStream(Files.newOutputStream(jar))) {
      FolderArchive.add(zip, "", source);
    }
    return jar;
  }
}
