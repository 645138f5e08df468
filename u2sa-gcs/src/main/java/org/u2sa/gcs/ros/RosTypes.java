package org.u2sa.gcs.ros;

import static org.u2sa.gcs.ros.RosSpelling.fields;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Definitions of the standard messages that the topics use, from ROS 2's interface files. Native
 * messages have none: their fields are optional, which those files cannot express.
 */
final class RosTypes {
  private static final Pattern FIELD =
      Pattern.compile("([A-Za-z0-9_/]+)(\\[(\\d*)])? ([a-z][A-Za-z0-9_]*)");
  private static final String TYPE_LINE = "MSG: ";
  private static final int SCALAR = -1;

  /**
   * @param length array length; 0 if it varies, -1 if the field is not an array
   */
  record Field(String type, int length, String name) {}

  private final Map<String, List<Field>> types = new LinkedHashMap<>(); // by ROS 1 name

  RosTypes() {
    try (InputStream in = RosTypes.class.getResourceAsStream("messages.txt")) {
      BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
      List<Field> current = null;
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith(TYPE_LINE)) {
          current = new ArrayList<>();
          types.put(line.substring(TYPE_LINE.length()), current);
        } else if (!line.isEmpty()) {
          current.add(field(line));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Field field(String line) {
    Matcher field = FIELD.matcher(line);
    if (!field.matches()) {
      throw new IllegalStateException("messages.txt: \"" + line + "\" is not a field");
    }
    String length = field.group(3);
    return new Field(
        field.group(1),
        length == null ? SCALAR : length.isEmpty() ? 0 : Integer.parseInt(length),
        field.group(4));
  }

  /** Answer of {@code rosapi/message_details}: the type and all types that it contains. */
  Optional<List<Object>> details(String type) {
    String name = RosSpelling.ros2(type).replace("/msg/", "/");
    if (!types.containsKey(name)) {
      return Optional.empty();
    }
    List<Object> details = new ArrayList<>();
    for (String each : within(name)) {
      List<Object> names = new ArrayList<>();
      List<Object> kinds = new ArrayList<>();
      List<Object> lengths = new ArrayList<>();
      List<Object> examples = new ArrayList<>();
      for (Field field : types.get(each)) {
        names.add(field.name());
        kinds.add(field.type());
        lengths.add(field.length());
        examples.add(field.length() != SCALAR ? "[]" : types.containsKey(field.type()) ? "{}" : "");
      }
      details.add(
          fields(
              "type",
              each,
              "fieldnames",
              names,
              "fieldtypes",
              kinds,
              "fieldarraylen",
              lengths,
              "examples",
              examples,
              "constnames",
              List.of(),
              "constvalues",
              List.of()));
    }
    return Optional.of(details);
  }

  /** Definition with those of all contained types, as ROS tools concatenate them. */
  String text(String type) {
    String name = RosSpelling.ros2(type).replace("/msg/", "/");
    if (!types.containsKey(name)) {
      return "";
    }
    StringBuilder text = new StringBuilder();
    for (String each : within(name)) {
      if (!each.equals(name)) {
        text.append("=".repeat(80)).append('\n').append(TYPE_LINE).append(each).append('\n');
      }
      for (Field field : types.get(each)) {
        text.append(field.type());
        if (field.length() != SCALAR) {
          text.append('[').append(field.length() == 0 ? "" : field.length()).append(']');
        }
        text.append(' ').append(field.name()).append('\n');
      }
    }
    return text.toString();
  }

  private Set<String> within(String type) {
    Set<String> found = new LinkedHashSet<>(List.of(type));
    List<String> open = new ArrayList<>(found);
    while (!open.isEmpty()) {
      for (Field field : types.get(open.remove(0))) {
        if (types.containsKey(field.type()) && found.add(field.type())) {
          open.add(field.type());
        }
      }
    }
    return found;
  }
}
