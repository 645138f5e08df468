package org.u2sa.cli.template;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.lang.model.SourceVersion;
import org.u2sa.interfaces.BadInputException;

/**
 * Name of a new service or project, in the forms needed in code and files.
 *
 * @param words lower-case words, such as depth, gauge
 */
record Naming(List<String> words) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9]*([ _-][A-Za-z0-9]+)*");
  private static final Pattern BETWEEN_WORDS =
      Pattern.compile("[ _-]|(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])");
  private static final Pattern PACKAGE = Pattern.compile("[A-Za-z]\\w*(\\.[A-Za-z]\\w*)*");
  private static final int LONGEST = 60;

  Naming {
    words = List.copyOf(words);
  }

  /**
   * Parses a name with any word separation: depth-gauge, DepthGauge, "depth gauge".
   *
   * @throws BadInputException if it is not valid as a name of classes, variables or folders
   */
  static Naming of(String name) {
    if (name.length() > LONGEST || !NAME.matcher(name).matches()) {
      throw new BadInputException(
          String.format(
              "name \"%s\": expected letters and digits, words joined by hyphens, up to %s characters, such as depth-gauge",
              name, LONGEST));
    }
    Naming naming =
        new Naming(
            Arrays.stream(BETWEEN_WORDS.split(name))
                .map(word -> word.toLowerCase(Locale.ROOT))
                .toList());
    if (SourceVersion.isKeyword(naming.variable())) {
      throw new BadInputException(
          "name \"" + name + "\" is a Java keyword; expected another, such as my-" + name);
    }
    if (isOfJava(naming.className())) {
      throw new BadInputException(
          String.format(
              "name \"%s\": java.lang has a class %s; expected another, such as my-%s",
              name, naming.className(), naming.hyphenated()));
    }
    return naming;
  }

  private static boolean isOfJava(String className) {
    return Object.class.getResource(className + ".class") != null;
  }

  /**
   * Returns the package name if valid.
   *
   * @throws BadInputException if not
   */
  static String checkedPackage(String name) {
    boolean reserved = name.equals("java") || name.startsWith("java.");
    if (!PACKAGE.matcher(name).matches() || !SourceVersion.isName(name) || reserved) {
      throw new BadInputException(
          "package \""
              + name
              + "\": expected names joined by dots, none of them a Java keyword or java itself, such as org.example.boat");
    }
    return name;
  }

  /** DepthGauge. */
  String className() {
    return words.stream().map(Naming::capitalised).collect(Collectors.joining());
  }

  private static String capitalised(String word) {
    return word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
  }

  /** depthGauge. */
  String variable() {
    String name = className();
    return name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1);
  }

  /** depth-gauge. */
  String hyphenated() {
    return String.join("-", words);
  }

  /** DEPTH GAUGE. */
  String capitals() {
    return spaced().toUpperCase(Locale.ROOT);
  }

  /** depth gauge. */
  String spaced() {
    return String.join(" ", words);
  }

  /** Default package of a project: org.example.depthgauge. */
  String defaultPackage() {
    return "org.example." + String.join("", words);
  }
}
