package org.u2sa.interfaces.configuration;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The audit log of one configuration file: JSON lines in {@code <file>.audit.jsonl} in the same
 * folder. A last line truncated by a power cut is removed, because its change was not started. At
 * one megabyte the log is rotated to {@code <file>.audit.jsonl.1}; the new log starts with the
 * latest changes, so rejected ones cannot displace them.
 *
 * <p>Read once; afterwards only additions by others are read.
 */
final class AuditFile implements ChangeJournal {
  private static final String SUFFIX = ".audit.jsonl";
  private static final String OLDER = ".1";
  private static final long MAX_BYTES = 1024 * 1024;
  private static final int MAX_READ_BYTES = 4 * 1024 * 1024; // limit for logs of older versions

  private final Path configuration;
  private Tail known = Tail.NONE; // accessed under the folder's lock, or before any change

  /**
   * @param configuration possibly a symbolic link
   */
  AuditFile(Path configuration) {
    this.configuration = configuration;
  }

  private Path target() throws IOException {
    return Files.exists(configuration)
        ? configuration.toRealPath()
        : configuration.toAbsolutePath();
  }

  private Path path() throws IOException {
    Path target = target();
    return target.resolveSibling(target.getFileName() + SUFFIX);
  }

  @Override
  public Closeable take() throws IOException {
    return FolderLock.take(target().getParent());
  }

  @Override
  public List<AuditEntry> recent() throws IOException {
    Path path = path();
    if (!exists(path)) {
      known = Tail.NONE;
    } else {
      boolean interrupted =
          Thread.interrupted(); // an interrupt would close the channel; restored below
      try (FileChannel file =
          FileChannel.open(path, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
        read(file, Files.readAttributes(path, BasicFileAttributes.class).fileKey());
      } finally {
        if (interrupted) {
          Thread.currentThread().interrupt();
        }
      }
    }
    return known.entries();
  }

  /** Rejects links, because they would be written through. */
  private static boolean exists(Path path) throws IOException {
    if (!Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    if (!Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException("the audit log " + path + " is not a regular file");
    }
    return true;
  }

  private void read(FileChannel file, Object key) throws IOException {
    long length = file.size();
    boolean same = known.isOf(key) && known.end() <= length;
    long from = same ? known.end() : Math.max(0L, length - MAX_READ_BYTES);
    if (same && length - from > MAX_READ_BYTES) {
      from = length - MAX_READ_BYTES;
      same = false;
    }
    ByteBuffer bytes = ByteBuffer.allocate((int) (length - from));
    while (bytes.hasRemaining() && file.read(bytes, from + bytes.position()) >= 0) {
      continue;
    }
    boolean cut = !same && from > 0; // the first line is then incomplete
    known = (same ? known : Tail.of(key, from)).with(bytes.array(), bytes.position(), cut);
  }

  @Override
  public void append(AuditEntry entry) throws IOException {
    Path path = path();
    recent();
    try {
      if (!exists(path)) {
        create(path);
      } else if (known.end() > MAX_BYTES) {
        keepAsOlder(path);
      }
      write(path, (entry.line() + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IOException("the audit log cannot be written: " + e, e);
    }
  }

  private void create(Path path) throws IOException {
    WholeFile.createPrivate(path);
    WholeFile.sync(path.getParent());
  }

  private void keepAsOlder(Path path) throws IOException {
    Path older = path.resolveSibling(path.getFileName() + OLDER);
    Files.deleteIfExists(older);
    try {
      Files.createLink(older, path);
    } catch (IOException | UnsupportedOperationException e) {
      // Not every file system or phone supports links.
      Files.copy(path, older, StandardCopyOption.COPY_ATTRIBUTES);
    }
    StringBuilder newest = new StringBuilder();
    known.entries().forEach(entry -> newest.append(entry.line()).append('\n'));
    WholeFile.replace(path, newest.toString().getBytes(StandardCharsets.UTF_8));
    recent();
  }

  private void write(Path path, byte[] line) throws IOException {
    if (Files.exists(target())) {
      WholeFile.FileOwnership.copy(target(), path);
    }
    boolean interrupted = Thread.interrupted();
    try (FileChannel file =
        FileChannel.open(path, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
      long end = known.end();
      file.truncate(end); // truncated by a power cut
      file.position(end);
      try {
        WholeFile.write(file, line);
        file.force(true);
      } catch (IOException e) {
        file.truncate(end);
        throw e;
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /**
   * Latest changes read from an audit log, and the last rejection.
   *
   * @param key file key of the file system; null if unavailable
   * @param end end of the last complete line read [bytes]
   * @param entries oldest first
   */
  private record Tail(Object key, long end, List<AuditEntry> entries) {
    static final Tail NONE = new Tail(null, 0, List.of());

    private static final int MAX_ENTRIES = 200;

    static Tail of(Object key, long from) {
      return new Tail(key, from, List.of());
    }

    /**
     * Whether it belongs to the file with this key, as it always does on file systems without keys.
     */
    boolean isOf(Object otherKey) {
      return end > 0 && Objects.equals(key, otherKey);
    }

    /**
     * @param cut whether the first line is incomplete and must be skipped
     */
    Tail with(byte[] bytes, int length, boolean cut) {
      int whole = length;
      while (whole > 0 && bytes[whole - 1] != '\n') {
        whole--;
      }
      List<AuditEntry> all = new ArrayList<>(entries);
      String[] lines = new String(bytes, 0, whole, StandardCharsets.UTF_8).split("\n");
      for (int i = cut ? 1 : 0; i < lines.length; i++) {
        AuditEntry.read(lines[i]).ifPresent(all::add);
      }
      return new Tail(key, end + whole, newest(all));
    }

    private static List<AuditEntry> newest(List<AuditEntry> all) {
      List<AuditEntry> kept = new ArrayList<>();
      for (int i = 0; i < all.size(); i++) {
        if (all.get(i).outcome() != AuditEntry.Outcome.REFUSED || i == all.size() - 1) {
          kept.add(all.get(i));
        }
      }
      return List.copyOf(kept.subList(Math.max(0, kept.size() - MAX_ENTRIES), kept.size()));
    }
  }
}
