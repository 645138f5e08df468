package org.u2sa.cli;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Explains errors in files of META-INF/services, in which jars list their extensions. */
final class ProviderFault {
  private static final Pattern NAMED = Pattern.compile("(\\S+): (?:Provider )?([\\w.$]+) (.*)");
  private static final String LISTS = "META-INF/services/";

  private ProviderFault() {}

  /** The explanation if a listed class is the cause. */
  static Optional<String> causeOf(Throwable thrown) {
    for (Throwable each = thrown; each != null; each = each.getCause()) {
      if (each instanceof ServiceConfigurationError error) {
        return Optional.of(explained(error));
      }
    }
    return Optional.empty();
  }

  /** The error with the file, its line and what was expected there. */
  static String explained(ServiceConfigurationError error) {
    String message = String.valueOf(error.getMessage());
    Matcher named = NAMED.matcher(message);
    if (!named.matches()) {
      return message; // names the file, such as for a syntax error
    }
    String kind = named.group(1);
    String provider = named.group(2);
    return String.format(
        "%s: provider %s %s%s; expected the full name of a public class that implements %s and has"
            + " a public constructor without parameters",
        placeOf(kind, provider),
        provider,
        named.group(3),
        error.getCause() == null ? "" : " (" + error.getCause() + ")",
        kind);
  }

  private static String placeOf(String kind, String provider) {
    try {
      ClassLoader loader = Thread.currentThread().getContextClassLoader(); // as ServiceLoader does
      for (URL list : Collections.list(loader.getResources(LISTS + kind))) {
        try (InputStream in = list.openStream()) {
          String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
          List<String> names =
              text.lines().map(line -> line.replaceFirst("#.*", "").trim()).toList();
          if (names.contains(provider)) {
            String file = list.toString().replaceFirst("^(jar:)?file:", "");
            return file + ", line " + (names.indexOf(provider) + 1);
          }
        }
      }
    } catch (IOException e) {
      return LISTS + kind + " (" + e + ")"; // a damaged jar
    }
    return LISTS + kind;
  }
}
