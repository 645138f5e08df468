package org.u2sa.cli.look;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.remote.MessageStream;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.message.FieldPath;
import org.u2sa.report.message.MessageJson;

/** Formats a message as text lines for people or as one line of JSON for programs. */
final class MessageText {
  private static final long MICROS = 1_000_000L;
  private static final int NANOS = 1_000;
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("HH:mm:ss.SSS").withZone(ZoneOffset.UTC);
  private static final String INDENT = "  ";
  private static final int LIST_ON_A_LINE = 8;

  private final List<FieldPath> wanted; // empty for all fields

  MessageText(List<FieldPath> wanted) {
    this.wanted = wanted;
  }

  /** Formats an arrival time in UTC. */
  static String time(long micros) {
    return TIME.format(
        Instant.ofEpochSecond(
            Math.floorDiv(micros, MICROS), Math.floorMod(micros, MICROS) * NANOS));
  }

  List<String> lines(MessageStream.Heard heard) {
    U2SAData message = heard.message();
    if (!wanted.isEmpty()) {
      StringBuilder line = new StringBuilder(time(heard.micros()));
      for (FieldPath path : wanted) {
        line.append("  ").append(path).append('=');
        line.append(path.value(message).map(v -> flat(v) + unit(path.unit(message))).orElse("-"));
      }
      return List.of(line.toString());
    }
    List<String> lines = new ArrayList<>();
    lines.add(heard.channel() + "  " + MessageJson.typeName(message) + "  " + time(heard.micros()));
    fields(message, INDENT, lines);
    return lines;
  }

  private static void fields(U2SAData message, String indent, List<String> lines) {
    int width = 0;
    for (FieldValue field : message.enumerateFields()) {
      width = field.value().isPresent() ? Math.max(width, field.name().length()) : width;
    }
    for (FieldValue field : message.enumerateFields()) {
      if (field.value().isEmpty()) {
        continue;
      }
      Object value = field.value().get();
      String name = field.name() + " ".repeat(width - field.name().length());
      if (value instanceof List<?> list && isLong(list)) {
        lines.add(
            indent + name + "  " + list.size() + (list.size() == 1 ? " element" : " elements"));
        elements(list, indent + INDENT, lines);
      } else {
        lines.add(indent + name + "  " + flat(value) + unit(field.unit()));
      }
    }
  }

  private static boolean isLong(List<?> list) {
    return !list.isEmpty() && (list.get(0) instanceof U2SAData || list.size() > LIST_ON_A_LINE);
  }

  private static void elements(List<?> list, String indent, List<String> lines) {
    if (list.get(0) instanceof U2SAData) {
      for (int i = 0; i < list.size(); i++) {
        U2SAData element = (U2SAData) list.get(i);
        lines.add(indent + "[" + i + "] " + MessageJson.typeName(element));
        fields(element, indent + INDENT, lines);
      }
      return;
    }
    for (int from = 0; from < list.size(); from += LIST_ON_A_LINE) {
      int to = Math.min(list.size(), from + LIST_ON_A_LINE);
      StringBuilder line = new StringBuilder(indent + "[" + from + "]");
      list.subList(from, to).forEach(value -> line.append(' ').append(flat(value)));
      lines.add(line.toString());
    }
  }

  private static String flat(Object value) {
    if (value instanceof Point point) {
      return "(" + point.x() + ", " + point.y() + ", " + point.z() + ")";
    }
    return String.valueOf(value);
  }

  private static String unit(String unit) {
    return unit.isEmpty() ? "" : " " + unit;
  }

  /** One line of JSON; its {@code fields} alone can be passed to {@code publish}. */
  String json(MessageStream.Heard heard) {
    U2SAData message = heard.message();
    JsonText json =
        new JsonText()
            .put("channel", heard.channel().name())
            .put("type", MessageJson.typeName(message))
            .put("receivedMicros", heard.micros());
    if (wanted.isEmpty()) {
      return json.put("fields", MessageJson.fields(message))
          .put("units", MessageJson.units(message))
          .line();
    }
    JsonText fields = new JsonText();
    JsonText units = new JsonText();
    for (FieldPath path : wanted) {
      Optional<Object> value = path.value(message);
      value.ifPresent(each -> fields.put(path.toString(), MessageJson.plain(each)));
      if (value.isPresent() && !path.unit(message).isEmpty()) {
        units.put(path.toString(), path.unit(message));
      }
    }
    return json.put("fields", fields).put("units", units).line();
  }
}
