package org.u2sa.gcs.remote;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.AccountFile;
import org.u2sa.interfaces.mqtt.AccountFolders;

/**
 * Registry of the systems run by this account on this machine and their broker addresses, so that a
 * command finds the right broker even if another program has the default port. One file per system,
 * named after its process, in each of the {@link AccountFolders}.
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

  private static final int MAX_BYTES = 1_000;

  private final AccountFolders folders;

  LocalSystems(AccountFolders folders) {
    this.folders = folders;
  }

  /** Opens the registry of this account. */
  public static LocalSystems ofAccount() {
    return new LocalSystems(AccountFolders.ofProcess());
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
   * @param broker address of its broker; empty if it has none, so that it is not announced
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
    long pid = ProcessHandle.current().pid();
    String start = ProcessIdentity.startOf(pid).orElseThrow();
    AccountFile file =
        new AccountFile(
            folders,
            pid + "-" + reached.port(),
            systemId + " " + reached + " " + start,
            failure ->
                console.accept(
                    "Commands that look there find this system only with --broker "
                        + reached
                        + ": "
                        + failure));
    return file::close;
  }

  /**
   * Returns the systems whose processes are running.
   *
   * @throws BadInputException if none is found and part of the registry cannot be read
   */
  public List<LocalSystem> running() {
    List<String> failures = new ArrayList<>();
    List<LocalSystem> running = running(failures::add);
    if (running.isEmpty() && !failures.isEmpty()) {
      throw new BadInputException(
          String.join("; ", failures) + "; --broker names the broker instead");
    }
    return running;
  }

  private List<LocalSystem> running(Consumer<String> failures) {
    Set<LocalSystem> running = new LinkedHashSet<>();
    for (Path folder : folders.readable()) {
      try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
        for (Path file : files) {
          read(file, failures).ifPresent(running::add);
        }
      } catch (IOException | DirectoryIteratorException e) {
        failures.accept(folder + ": " + e);
      }
    }
    return List.copyOf(running);
  }

  /**
   * Returns the system of a file; empty if its process ended without removing it, if its PID now
   * belongs to another process, or if it is not such a file.
   */
  private static Optional<LocalSystem> read(Path file, Consumer<String> failures) {
    String name = file.getFileName().toString();
    if (!name.matches("\\d{1,9}-\\d{1,5}")) {
      return Optional.empty();
    }
    Optional<String> start = ProcessIdentity.startOf(Long.parseLong(name.split("-")[0]));
    if (start.isEmpty()) {
      return forgotten(file);
    }
    try (InputStream in = Files.newInputStream(file)) {
      String text = new String(in.readNBytes(MAX_BYTES), StandardCharsets.UTF_8);
      String[] words = text.trim().split(" ");
      return words.length == 3 && words[2].equals(start.get())
          ? Optional.of(new LocalSystem(words[0], BrokerAddress.parse(words[1])))
          : forgotten(file);
    } catch (NoSuchFileException e) {
      return Optional.empty(); // its process ended just now
    } catch (IOException e) {
      failures.accept(file + ": " + e);
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return forgotten(file);
    }
  }

  private static Optional<LocalSystem> forgotten(Path file) {
    try {
      Files.deleteIfExists(file);
    } catch (IOException e) {
      return Optional.empty(); // e.g. the disk became read-only; the entry is outdated anyway
    }
    return Optional.empty();
  }

  /** IDs of the systems at a broker; empty if the registry cannot be read. */
  public Set<String> at(BrokerAddress broker) {
    try {
      return running().stream()
          .filter(each -> each.broker().equals(broker))
          .map(LocalSystem::systemId)
          .collect(Collectors.toSet());
    } catch (BadInputException e) {
      return Set.of(); // they are also in the broker's messages
    }
  }

  /**
   * Returns the broker addresses of the running systems, each once, as far as the registry can be
   * read.
   *
   * @param systemId wanted system; empty for any
   * @param failures receives a line for each part of the registry that cannot be read
   */
  public List<BrokerAddress> brokers(Optional<String> systemId, Consumer<String> failures) {
    return brokers(meant(systemId, running(failures)));
  }

  private static List<BrokerAddress> brokers(List<LocalSystem> systems) {
    return systems.stream().map(LocalSystem::broker).distinct().toList();
  }

  private static List<LocalSystem> meant(Optional<String> systemId, List<LocalSystem> running) {
    return running.stream()
        .filter(each -> systemId.isEmpty() || each.systemId().equals(systemId.get()))
        .sorted(Comparator.comparing(LocalSystem::toString))
        .toList();
  }

  /**
   * Returns the broker address of the only running system; empty if none runs.
   *
   * @param systemId wanted system; empty for any
   * @throws BadInputException if several brokers match
   */
  public Optional<BrokerAddress> theOnly(Optional<String> systemId) {
    List<LocalSystem> meant = meant(systemId, running());
    List<BrokerAddress> brokers = brokers(meant);
    if (brokers.size() > 1) {
      throw new BadInputException(
          "several systems run on this machine: "
              + meant.stream().map(LocalSystem::toString).collect(Collectors.joining(", "))
              + "; choose one with --system or --broker");
    }
    return brokers.stream().findFirst();
  }
}
