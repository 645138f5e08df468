package org.u2sa.core.communication.limit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;

/** Maximum number of files and connections that this process may open. */
public final class OpenFiles {
  private static final Path LIMITS = Paths.get("/proc/self/limits"); // Linux and Android
  private static final Path OPEN = Paths.get("/proc/self/fd");
  private static final int OF_SERVICES = 64; // and of the network threads
  private static final Pattern SOFT = Pattern.compile("Max open files +(\\d{1,9}) ");

  private OpenFiles() {}

  /**
   * The limits with as many clients as this allows; reports a reduction.
   *
   * @throws BadInputException if the process may open so few files that an operator might not be
   *     able to connect
   */
  public static BrokerLimits fitted(BrokerLimits configured, Consumer<String> log) {
    OptionalInt openFiles = limit();
    openFiles.ifPresent(most -> requireEnough(most, open()));
    BrokerLimits limits =
        openFiles.isPresent() ? configured.within(openFiles.getAsInt()) : configured;
    if (limits.maxClients() < configured.maxClients()) {
      log.accept(
          String.format(
              "MAX CLIENTS %d lowered to %d: this process may have %d files open",
              configured.maxClients(), limits.maxClients(), openFiles.getAsInt()));
    }
    return limits;
  }

  /**
   * @param open number of those open now, before the broker and the services start
   */
  static void requireEnough(int most, int open) {
    int needed = Math.max(BrokerLimits.OWN_FILES, open + OF_SERVICES) + BrokerLimits.MIN_CLIENTS;
    if (most < needed) {
      throw new BadInputException(
          String.format(
              "this process may have %d files open and needs %d, or nobody could connect to stop the"
                  + " vehicle: raise the limit, for example with ulimit -n 1024",
              most, needed));
    }
  }

  /** Number of files and connections that are open; 0 if unknown. */
  private static int open() {
    try (Stream<Path> open = Files.list(OPEN)) {
      return (int) open.count();
    } catch (IOException | UncheckedIOException e) {
      return 0; // other operating systems
    }
  }

  /** The maximum; empty if unlimited or unknown. */
  static OptionalInt limit() {
    try {
      return limit(new String(Files.readAllBytes(LIMITS), StandardCharsets.US_ASCII));
    } catch (IOException e) {
      return OptionalInt.empty(); // other operating systems
    }
  }

  static OptionalInt limit(String limits) {
    Matcher found = SOFT.matcher(limits);
    return found.find() ? OptionalInt.of(Integer.parseInt(found.group(1))) : OptionalInt.empty();
  }
}
