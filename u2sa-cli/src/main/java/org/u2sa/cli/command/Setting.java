package org.u2sa.cli.command;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.configuration.InferredValue;
import org.u2sa.interfaces.xml.NearestNames;

/**
 * A configuration variable set on the command line.
 *
 * @param service the simple name of the service's class, or CommunicationManager
 * @param variable the variable's name
 * @param value String, or {@link InferredValue} of a text that is a Boolean, Integer or Double
 */
public record Setting(String service, String variable, Object value) {
  private static final String MANAGER = "CommunicationManager";
  private static final Pattern FORM = Pattern.compile("([^:=]+):([^=]+)=(.*)", Pattern.DOTALL);

  /**
   * Parses {@code SERVICE:VARIABLE=VALUE}.
   *
   * @throws IllegalArgumentException if the text does not have that form
   */
  public static Setting parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException("\"" + text + "\": expected SERVICE:VARIABLE=VALUE");
    }
    return new Setting(matcher.group(1), matcher.group(2), value(matcher.group(3)));
  }

  /**
   * Parses several settings.
   *
   * @throws IllegalArgumentException if a text does not have that form, or a variable is set twice
   */
  public static List<Setting> parseAll(List<String> texts) {
    List<Setting> settings = new ArrayList<>();
    for (String text : texts) {
      Setting setting = parse(text);
      for (Setting other : settings) {
        if (other.service.equals(setting.service) && other.variable.equals(setting.variable)) {
          throw new IllegalArgumentException(
              "\"" + text + "\": the variable is set to " + other.value + " already");
        }
      }
      settings.add(setting);
    }
    return settings;
  }

  /**
   * Rejects settings of absent services, which would silently have no effect.
   *
   * @param system all services, as in the system file
   * @throws IllegalArgumentException naming the available services and the closest match
   */
  public void requireServiceOf(SystemFile system) {
    Set<String> known = new LinkedHashSet<>();
    system.services().forEach(entry -> known.add(entry.simpleName()));
    known.add(MANAGER);
    if (!known.contains(service)) {
      throw new IllegalArgumentException(
          String.format(
              "\"%s:%s=%s\": %s lists no service of class \"%s\"; expected one of %s%s",
              service,
              variable,
              value,
              system.file(),
              service,
              String.join(", ", known),
              NearestNames.didYouMean(service, known)));
    }
  }

  private static Object value(String text) {
    if (text.equalsIgnoreCase("true") || text.equalsIgnoreCase("false")) {
      return new InferredValue(text, Boolean.valueOf(text));
    }
    if (text.matches("[+-]?\\d{1,9}")) {
      return new InferredValue(text, Integer.valueOf(text));
    }
    if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
      return new InferredValue(text, Double.valueOf(text));
    }
    return text;
  }
}
