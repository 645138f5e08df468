package org.u2sa.gcs.template;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;

/**
 * What stands for {@code {{Name}}} and the like in templates.
 *
 * @param values by the word between the braces
 */
record Placeholders(Map<String, String> values) {
  private static final Pattern PLACEHOLDER = Pattern.compile("\\{\\{(\\w+)}}");

  Placeholders {
    values = Map.copyOf(values);
  }

  /**
   * The text with all placeholders filled in.
   *
   * @param origin the template file, for the error
   * @throws BadInputException if a placeholder is not known
   */
  String fill(String text, String origin) {
    Matcher matcher = PLACEHOLDER.matcher(text);
    StringBuilder filled = new StringBuilder();
    while (matcher.find()) {
      String value = values.get(matcher.group(1));
      if (value == null) {
        long line = text.substring(0, matcher.start()).lines().count();
        throw new BadInputException(
            String.format(
                "%s, line %s: unknown placeholder %s; expected one of %s%s",
                origin,
                Math.max(1, line),
                matcher.group(),
                String.join(", ", values.keySet().stream().sorted().toList()),
                NearestNames.didYouMean(matcher.group(1), values.keySet())));
      }
      matcher.appendReplacement(filled, Matcher.quoteReplacement(value));
    }
    return matcher.appendTail(filled).toString();
  }

  /** A file's place in the project; a package's name becomes folders. */
  String fillPath(String path, String origin) {
    return fill(path.replace("{{package}}", values.get("package").replace('.', '/')), origin);
  }
}
