package org.u2sa.cli.template;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;

/** Renders the files of several templates; for the same path, the later template wins. */
final class Rendering {
  private static final String CLASS_NAME = "Name";

  private final SortedMap<String, byte[]> files = new TreeMap<>();
  private final Set<String> shared = new HashSet<>();

  /**
   * @param templates in order, ending with the kind's own
   * @throws BadInputException if a template file is malformed, or uses a class that has the new
   *     class's name
   */
  Rendering(Templates source, List<String> templates, Placeholders placeholders) {
    String own = templates.get(templates.size() - 1);
    for (String template : templates) {
      for (Map.Entry<String, Templates.File> each : source.files(template).entrySet()) {
        String origin = each.getValue().origin();
        String place = placeholders.fillPath(each.getKey(), origin);
        files.put(place, filled(each.getValue(), placeholders));
        if (template.equals(own)) {
          shared.remove(place);
        } else {
          shared.add(place);
        }
      }
    }
  }

  private static byte[] filled(Templates.File file, Placeholders placeholders) {
    for (byte each : file.content()) {
      if (each == 0) {
        return file.content(); // binary file
      }
    }
    String text;
    try {
      text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(file.content())).toString();
    } catch (CharacterCodingException e) {
      throw new BadInputException(file.origin() + ": expected UTF-8 (" + e.getMessage() + ")", e);
    }
    String className = placeholders.values().get(CLASS_NAME);
    if (file.origin().endsWith(".java")
        && Pattern.compile("\\b" + className + "\\b").matcher(text).find()) {
      throw new BadInputException(
          String.format(
              "name %s: %s uses a class of that name; expected another", className, file.origin()));
    }
    return placeholders.fill(text, file.origin()).getBytes(StandardCharsets.UTF_8);
  }

  SortedMap<String, byte[]> files() {
    return files;
  }

  /** Paths of files that other services of the project may already have added. */
  Set<String> shared() {
    return shared;
  }

  /** Values of placeholders such as {@code {{Name}}}, by the word between the braces. */
  record Placeholders(Map<String, String> values) {
    private static final Pattern PLACEHOLDER = Pattern.compile("\\{\\{(\\w+)}}");

    Placeholders {
      values = Map.copyOf(values);
    }

    /**
     * Returns the text with all placeholders replaced.
     *
     * @param origin the template file, for the error
     * @throws BadInputException if a placeholder is unknown
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

    /** Path of a file in the project; package names become folders. */
    String fillPath(String path, String origin) {
      return fill(path.replace("{{package}}", values.get("package").replace('.', '/')), origin);
    }
  }
}
