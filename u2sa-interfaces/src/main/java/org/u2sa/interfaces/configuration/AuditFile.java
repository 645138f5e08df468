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
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The audit log of one configuration file: JSON lines in {@code <file>.audit.jsonl} beside it, so
 * that it moves, is backed up and is deleted with what it explains, and survives the logs of one
 * run. A last line that a power cut has torn is removed: what it announced was not begun. A log of
 * a megabyte becomes {@code <file>.audit.jsonl.1}, in place of the one before; the new one begins
 * with the newest changes, so that refused ones cannot push them out.
 *
 * <p>Read once; from then on only what others have added.
 */
final class AuditFile implements ChangeJournal {
  private static final String SUFFIX = ".audit.jsonl";
  private static final String OLDER = ".1";
  private static final long MOST_BYTES = 1024 * 1024;
  private static final int MOST_READ_BYTES = 4 * 1024 * 1024; // of a log of an older version

  private final Path configuration;
  private Tail known = Tail.NONE; // used under the folder's lock, or before any change

  /**
   * @param configuration the configuration file, which may be a link
   */
  AuditFile(Path configuration) {
    this.configuration = configuration;
  }

  /** The configuration file itself, behind links. */
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
      boolean interrupted = Thread.interrupted(); // would close the channel; given back below
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

  /** Whether the log is there. Only a file will do: a link would be written through. */
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
    long from = same ? known.end() : Math.max(0L, length - MOST_READ_BYTES);
    if (same && length - from > MOST_READ_BYTES) {
      from = length - MOST_READ_BYTES;
      same = false;
    }
    ByteBuffer bytes = ByteBuffer.allocate((int) (length - from));
    while (bytes.hasRemaining() && file.read(bytes, from + bytes.position()) >= 0) {
      continue;
    }
    boolean cut = !same && from > 0; // the first line then is half a line
    known = (same ? known : Tail.of(key, from)).with(bytes.array(), bytes.position(), cut);
  }

  @Override
  public void append(AuditEntry entry) throws IOException {
    Path path = path();
    recent();
    try {
      if (!exists(path)) {
        create(path);
      } else if (known.end() > MOST_BYTES) {
        keepAsOlder(path);
      }
      write(path, (entry.line() + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IOException("the audit log cannot be written: " + e, e);
    }
  }

  /** Readable and writable by whom the configuration file is. */
  private void create(Path path) throws IOException {
    if (path.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      Files.createFile(
          path, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
    } else {
      Files.createFile(path);
    }
    WholeFile.sync(path.getParent());
  }

  private void keepAsOlder(Path path) throws IOException {
    Path older = path.resolveSibling(path.getFileName() + OLDER);
    Files.deleteIfExists(older);
    try {
      Files.createLink(older, path);
    } catch (IOException | UnsupportedOperationException e) {
      // Not every file system and not every phone has links.
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
      file.truncate(end); // a line that a power cut has torn
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
   * The newest entries of an audit log, as far as it was read: the newest changes, and the last
   * refusal. Immutable.
   *
   * @param key what the file system calls the file; null if there is none
   * @param end where the last whole line that was read ends [bytes]
   * @param entries oldest first
   */
  private record Tail(Object key, long end, List<AuditEntry> entries) {
    /** Of a log that is not there. */
    static final Tail NONE = new Tail(null, 0, List.of());

    private static final int MOST_ENTRIES = 200;

    /** Of a log of which nothing was read yet, from a place in it. */
    static Tail of(Object key, long from) {
      return new Tail(key, from, List.of());
    }

    /** Whether it tells of the file of that key. File systems without keys have one name a file. */
    boolean isOf(Object otherKey) {
      return end > 0 && Objects.equals(key, otherKey);
    }

    /**
     * This tail and what follows in the file.
     *
     * @param cut whether the first line is half a line, to be passed over
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
      return List.copyOf(kept.subList(Math.max(0, kept.size() - MOST_ENTRIES), kept.size()));
    }
  }
}
