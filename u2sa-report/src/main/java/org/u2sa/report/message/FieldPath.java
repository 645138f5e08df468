package org.u2sa.report.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/**
 * Path to a value in a message: {@code psi}, {@code ranges[3]}, {@code point.x}, {@code
 * goals[0].uid}, {@code objects.size}. A negative index counts from the end.
 */
public final class FieldPath {
  private static final Pattern STEP = Pattern.compile("([A-Za-z_][A-Za-z0-9_]*)|\\[(-?\\d{1,9})]");

  private final String text;
  private final List<Object> steps = new ArrayList<>(); // names and indexes

  private FieldPath(String text) {
    this.text = text;
  }

  /**
   * Parses a path.
   *
   * @throws IllegalArgumentException if malformed
   */
  public static FieldPath parse(String text) {
    FieldPath path = new FieldPath(text);
    Matcher step = STEP.matcher(text);
    int at = 0;
    while (at < text.length()) {
      boolean dot = at > 0 && text.charAt(at) == '.';
      if (!step.find(at) || step.start() != (dot ? at + 1 : at)) {
        throw bad(text);
      }
      boolean name = step.group(1) != null;
      if (at > 0 && name != dot || at == 0 && !name) {
        throw bad(text);
      }
      path.steps.add(name ? step.group(1) : Integer.valueOf(step.group(2)));
      at = step.end();
    }
    if (path.steps.isEmpty()) {
      throw bad(text);
    }
    return path;
  }

  private static IllegalArgumentException bad(String text) {
    return new IllegalArgumentException(
        "\"" + text + "\": expected a field, such as psi, ranges[3], point.x or goals[0].uid");
  }

  /** Name of the message field at the start of the path. */
  public String field() {
    return (String) steps.get(0);
  }

  /** Value in a message; empty if absent. */
  public Optional<Object> value(U2SAData message) {
    Object at = message;
    for (Object step : steps) {
      at = step instanceof Integer index ? element(at, index) : named(at, (String) step);
      if (at == null) {
        return Optional.empty();
      }
    }
    return Optional.of(at);
  }

  /** Value as a number, with flags as 0 or 1; empty if absent or not a number. */
  public OptionalDouble number(U2SAData message) {
    Object value = value(message).orElse(null);
    if (value instanceof Number number) {
      return OptionalDouble.of(number.doubleValue());
    }
    if (value instanceof Boolean flag) {
      return OptionalDouble.of(flag ? 1.0 : 0.0);
    }
    return OptionalDouble.empty();
  }

  /** Unit of the value in this message; empty if none. */
  public String unit(U2SAData message) {
    boolean counts = steps.get(steps.size() - 1).equals("size");
    return counts
        ? ""
        : message.enumerateFields().stream()
            .filter(field -> field.name().equals(field()) && steps.size() <= 2)
            .map(FieldValue::unit)
            .findFirst()
            .orElse("");
  }

  private static Object element(Object of, int index) {
    if (of instanceof List<?> list) {
      int at = index < 0 ? list.size() + index : index;
      return at >= 0 && at < list.size() ? list.get(at) : null;
    }
    return null;
  }

  private static Object named(Object of, String name) {
    if (of instanceof U2SAData message) {
      return message.enumerateFields().stream()
          .filter(field -> field.name().equals(name))
          .findFirst()
          .flatMap(FieldValue::value)
          .orElse(null);
    }
    if (of instanceof Point point) {
      return switch (name) {
        case "x" -> point.x();
        case "y" -> point.y();
        case "z" -> point.z();
        default -> null;
      };
    }
    if (of instanceof List<?> list) {
      return name.equals("size") ? list.size() : null;
    }
    return of instanceof Map<?, ?> map ? map.get(name) : null;
  }

  @Override
  public String toString() {
    return text;
  }
}
