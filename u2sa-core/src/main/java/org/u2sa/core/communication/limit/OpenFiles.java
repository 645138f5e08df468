package org.u2sa.core.communication.limit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Files and connections that the operating system lets this process have open. */
public final class OpenFiles {
  private static final Path LIMITS = Paths.get("/proc/self/limits"); // Linux and Android
  private static final Pattern SOFT = Pattern.compile("Max open files +(\\d{1,9}) ");

  private OpenFiles() {}

  /** Their number; empty if there is no limit, or the system does not tell. */
  public static OptionalInt limit() {
    try {
      return limit(new String(Files.readAllBytes(LIMITS), StandardCharsets.US_ASCII));
    } catch (IOException e) {
      return OptionalInt.empty(); // another operating system
    }
  }

  static OptionalInt limit(String limits) {
    Matcher found = SOFT.matcher(limits);
    return found.find() ? OptionalInt.of(Integer.parseInt(found.group(1))) : OptionalInt.empty();
  }
}
