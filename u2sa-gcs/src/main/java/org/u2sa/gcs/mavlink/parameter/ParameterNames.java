package org.u2sa.gcs.mavlink.parameter;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;
import java.util.zip.CRC32;

/**
 * Names of at most 16 characters for configuration variables, such as SAFM_BRAKING for BRAKING of
 * the SafetyManager. A name depends on service and variable only, unless two would be equal.
 */
final class ParameterNames {
  static final int LONGEST = 16;
  private static final int FIRST_WORD = 3;
  private static final int HASH = 3;
  private static final int RADIX = 36;

  private ParameterNames() {}

  /** A name that is not taken yet. */
  static String of(String service, String variable, Set<String> taken) {
    String prefix = prefix(service) + "_";
    String words = words(variable);
    int room = LONGEST - prefix.length();
    String shortened = words.length() <= room ? words : withoutVowels(words);
    String hash = hash(service + ":" + variable);
    String name =
        prefix
            + (shortened.length() <= room
                ? shortened
                : shortened.substring(0, room - HASH - 1) + "_" + hash);
    if (!taken.contains(name)) {
      return name;
    }
    return prefix + words.substring(0, Math.min(words.length(), room - HASH - 1)) + "_" + hash;
  }

  /** Three letters of the service's first word and the initials of the others. */
  private static String prefix(String service) {
    String[] parts =
        service.replaceAll("[^A-Za-z0-9]+", " ").trim().split("(?<=[a-z0-9])(?=[A-Z])| ");
    StringBuilder prefix = new StringBuilder();
    for (String part : parts) {
      if (!part.isEmpty() && prefix.length() < FIRST_WORD + 2) {
        prefix.append(part, 0, prefix.length() == 0 ? Math.min(FIRST_WORD, part.length()) : 1);
      }
    }
    return prefix.toString().toUpperCase(Locale.ROOT);
  }

  private static String words(String variable) {
    return variable.toUpperCase(Locale.ROOT).replaceAll("[^A-Z0-9]+", "_");
  }

  private static String withoutVowels(String words) {
    return words.replaceAll("(?<=[A-Z0-9])[AEIOU]", "");
  }

  private static String hash(String text) {
    CRC32 crc = new CRC32();
    crc.update(text.getBytes(StandardCharsets.UTF_8));
    String digits = "00" + Long.toString(crc.getValue(), RADIX).toUpperCase(Locale.ROOT);
    return digits.substring(digits.length() - HASH);
  }
}
