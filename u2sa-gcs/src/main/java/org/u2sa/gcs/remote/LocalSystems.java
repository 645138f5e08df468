package org.u2sa.gcs.remote;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;

/**
 * Registry of the systems run by this account on this machine and their broker addresses, so that a
 * command finds the right broker even if another program has the default port. One file per system,
 * named after its process, in a folder writable only by this account.
 */
public final class LocalSystems {
  /**
   * A system.
   *
   * @param broker where its own broker listens
   */
  public record LocalSystem(String systemId, BrokerAddress broker) {
    @Override
    public String toString() {
      return systemId + " at " + broker;
    }
  }

  private static final String FOLDER = "u2sa.systems"; // property, for tests
  private static final int MAX_BYTES = 1_000;

  private final Path folder;

  LocalSystems(Path folder) {
    this.folder = folder;
  }

  /** Opens the registry of this account. */
  public static LocalSystems ofAccount() {
    String chosen = System.getProperty(FOLDER, "");
    String runtime = System.getenv().getOrDefault("XDG_RUNTIME_DIR", "");
    if (!chosen.isEmpty()) {
      return new LocalSystems(Path.of(chosen));
    }
    return new LocalSystems(
        runtime.isEmpty()
            ? Path.of(
                System.getProperty("java.io.tmpdir"), "u2sa-" + System.getProperty("user.name"))
            : Path.of(runtime, "u2sa"));
  }

  /** Withdraws what {@link #announce} announced. */
  @FunctionalInterface
  public interface Announcement extends AutoCloseable {
    @Override
    void close();
  }

  /**
   * Announces a system of this process.
   *
   * @param broker address of its own broker; empty if it has none, and then it is not announced
   * @param console receives a line if that fails, which does not prevent the run
   */
  public Announcement announce(
      String systemId, Optional<InetSocketAddress> broker, Consumer<String> console) {
    if (broker.isEmpty()) {
      return () -> {};
    }
    InetAddress address = broker.get().getAddress();
    boolean isHere = address.isAnyLocalAddress() || address.isLoopbackAddress();
    BrokerAddress reached =
        new BrokerAddress(isHere ? "localhost" : address.getHostAddress(), broker.get().getPort());
    Path file = folder.resolve(ProcessHandle.current().pid() + "-" + reached.port());
    try {
      prepare();
      Files.writeString(file, systemId + " " + reached);
    } catch (IOException e) {
      console.accept("Commands find this system by --broker " + reached + " only: " + e);
      return () -> {};
    }
    return () -> remove(file, console);
  }

  private void prepare() throws IOException {
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      Files.createDirectories(folder.toAbsolutePath().getParent());
      if (folder.getFileSystem().supportedFileAttributeViews().contains("posix")) {
        Files.createDirectory(
            folder,
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
      } else {
        Files.createDirectory(folder);
      }
    }
    if (!isOurs()) {
      throw new IOException(folder + " belongs to another account");
    }
  }

  private boolean isOurs() throws IOException {
    String owner = Files.getOwner(folder, LinkOption.NOFOLLOW_LINKS).getName();
    return owner.equals(System.getProperty("user.name"));
  }

  private static void remove(Path file, Consumer<String> console) {
    try {
      Files.deleteIfExists(file);
    } catch (IOException e) {
      console.accept("cannot remove " + file + ": " + e.getMessage());
    }
  }

  /** Returns the systems whose processes are running. */
  public List<LocalSystem> running() {
    List<LocalSystem> running = new ArrayList<>();
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      return running;
    }
    try {
      if (!isOurs()) {
        return running;
      }
      try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
        for (Path file : files) {
          read(file).ifPresent(running::add);
        }
      }
      return running;
    } catch (IOException e) {
      throw new BadInputException(folder + ": " + e + "; --broker names the broker instead", e);
    }
  }

  /**
   * Returns the system of a file; empty if the process ended without removing it, or if it is
   * another file.
   */
  private static Optional<LocalSystem> read(Path file) throws IOException {
    String name = file.getFileName().toString();
    if (!name.matches("\\d{1,9}-\\d{1,5}") || Files.size(file) > MAX_BYTES) {
      return Optional.empty();
    }
    long pid = Long.parseLong(name.substring(0, name.indexOf('-')));
    if (ProcessHandle.of(pid).filter(ProcessHandle::isAlive).isEmpty()) {
      Files.deleteIfExists(file);
      return Optional.empty();
    }
    String[] words = Files.readString(file).trim().split(" ");
    return words.length == 2
        ? Optional.of(new LocalSystem(words[0], BrokerAddress.parse(words[1])))
        : Optional.empty(); // it is being written
  }

  /** IDs of the systems at a broker; empty if the registry cannot be read. */
  public Set<String> at(BrokerAddress broker) {
    try {
      return running().stream()
          .filter(each -> each.broker().equals(broker))
          .map(LocalSystem::systemId)
          .collect(Collectors.toSet());
    } catch (BadInputException e) {
      return Set.of(); // the broker's messages tell them too
    }
  }

  /**
   * Returns the broker address of the only running system; empty if none runs.
   *
   * @param systemId wanted system; empty for any
   * @throws BadInputException if several brokers match
   */
  public Optional<BrokerAddress> theOnly(Optional<String> systemId) {
    List<LocalSystem> meant =
        running().stream()
            .filter(each -> systemId.isEmpty() || each.systemId().equals(systemId.get()))
            .sorted((a, b) -> a.toString().compareTo(b.toString()))
            .toList();
    List<BrokerAddress> brokers = meant.stream().map(LocalSystem::broker).distinct().toList();
    if (brokers.size() > 1) {
      throw new BadInputException(
          "several systems run on this machine: "
              + meant.stream().map(LocalSystem::toString).collect(Collectors.joining(", "))
              + "; --system or --broker chooses one");
    }
    return brokers.stream().findFirst();
  }
}
