package org.u2sa.gcs.mavlink.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The folder of recordings for download: {@code .mcap} and {@code .ulg} files directly in it, no
 * links. The oldest name comes first.
 */
public final class RecordingFolder {
  /**
   * A recording.
   *
   * @param size [B]
   * @param seconds time of its last change, since 1970 [s]
   */
  record Entry(String name, Path file, long size, long seconds, RecordingDisk disk) {
    ReadableFile open() {
      return new RecordingFile(file, size, disk);
    }
  }

  private static final Pattern NAME =
      Pattern.compile("[A-Za-z0-9_][A-Za-z0-9._-]{0,99}\\.(mcap|ulg)");
  private static final int MAX_FILES = 256;
  private static final long LARGEST = 0xFFFF_FFFFL; // the protocols count bytes in 32 bits

  private final Path folder;
  private final RecordingDisk disk = new RecordingDisk();

  /** A folder, which need not exist yet. */
  public RecordingFolder(Path folder) {
    this.folder = folder;
  }

  /** Recordings in the order of their names; the newest 256. */
  List<Entry> entries() throws IOException {
    return disk.answer(this::listed);
  }

  private List<Entry> listed() throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    List<Path> files;
    try (Stream<Path> all = Files.list(folder)) {
      files =
          all.filter(each -> NAME.matcher(each.getFileName().toString()).matches())
              .sorted()
              .toList();
    }
    List<Entry> entries = new ArrayList<>();
    for (Path each : files.subList(Math.max(0, files.size() - MAX_FILES), files.size())) {
      BasicFileAttributes facts =
          Files.readAttributes(each, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
      if (facts.isRegularFile() && facts.size() <= LARGEST) {
        entries.add(
            new Entry(
                each.getFileName().toString(),
                each,
                facts.size(),
                facts.lastModifiedTime().toMillis() / 1000,
                disk));
      }
    }
    return entries;
  }

  /** Recording with a name; empty if it does not exist. */
  Optional<Entry> entry(String name) throws IOException {
    return entries().stream().filter(each -> each.name().equals(name)).findFirst();
  }
}
