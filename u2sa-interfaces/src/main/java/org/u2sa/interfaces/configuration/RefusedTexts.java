package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.contract.ConfigurationAssignment;

/**
 * What was asked for, as far as answer and audit log repeat it: whoever asks may ask for anything,
 * of any length.
 */
final class RefusedTexts {
  private static final int LONGEST = 200;
  private static final int SHOWN = 16;
  private static final int MOST_VARIABLES = 256;
  private static final int LONGEST_VALUE = 2_000;

  private RefusedTexts() {}

  /**
   * Refuses oversized changes.
   *
   * @throws ConfigurationException if there are too many variables, or texts are too long
   */
  static void refuseTooMuch(Map<String, ?> wanted, String origin) {
    if (wanted.size() > MOST_VARIABLES) {
      throw new ConfigurationException(
          String.format(
              "%s: %s variables at once, expected %s at most",
              origin, wanted.size(), MOST_VARIABLES));
    }
    wanted.forEach(
        (name, value) -> {
          int length = Math.max(name.length(), String.valueOf(value).length());
          if (length > LONGEST_VALUE) {
            throw new ConfigurationException(
                String.format(
                    "%s, variable \"%s\": %s characters, expected %s at most",
                    origin, shortened(name), length, LONGEST_VALUE));
          }
        });
  }

  /** The first variables with their values, cut to a length that can be shown. */
  static Map<String, String> of(Map<String, ?> wanted) {
    Map<String, String> texts = new LinkedHashMap<>();
    for (Map.Entry<String, ?> entry : wanted.entrySet()) {
      if (texts.size() == SHOWN) {
        break;
      }
      texts.put(shortened(entry.getKey()), shortened(String.valueOf(entry.getValue())));
    }
    return texts;
  }

  static List<AuditEntry.Value> audited(Map<String, String> texts) {
    List<AuditEntry.Value> values = new ArrayList<>();
    texts.forEach(
        (name, text) ->
            values.add(
                new AuditEntry.Value(
                    name, Optional.empty(), text, Optional.empty(), Optional.empty())));
    return values;
  }

  static List<ConfigurationAssignment> answered(Map<String, String> texts) {
    List<ConfigurationAssignment> asked = new ArrayList<>();
    texts.forEach(
        (name, text) -> asked.add(new ConfigurationAssignment().variableName(name).value(text)));
    return asked;
  }

  private static String shortened(String text) {
    return shortened(text, LONGEST);
  }

  static String shortened(String text, int longest) {
    return text.length() <= longest ? text : text.substring(0, longest) + "…";
  }
}
