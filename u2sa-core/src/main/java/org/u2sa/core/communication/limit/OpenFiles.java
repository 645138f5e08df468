package org.u2sa.core.communication.limit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Maximum number of files and connections that this process may open. */
public final class OpenFiles {
  private static final Path LIMITS = Paths.get("/proc/self/limits"); // Linux and Android
  private static final Pattern SOFT = Pattern.compile("Max open files +(\\d{1,9}) ");

  private OpenFiles() {}

  /** The limits with as many clients as this allows; reports a reduction. */
  public static BrokerLimits fitted(BrokerLimits configured, Consumer<String> log) {
    OptionalInt openFiles = limit();
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
