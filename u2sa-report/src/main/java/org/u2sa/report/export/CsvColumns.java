package org.u2sa.report.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.message.MessageJson;

/**
 * Columns of one table: the union of its messages' fields. A field has one column per unit, because
 * coordinates have different units in different frames; a point has one per axis.
 */
final class CsvColumns {
  private static final String TIME = "time [s]";
  private static final String BEGINS_FORMULA = "=+-@\t\r"; // OWASP, CSV injection

  private final Set<String> heads = new LinkedHashSet<>();

  void learn(U2SAData message) {
    heads.addAll(cells(message).keySet());
  }

  String head() {
    List<String> row = new ArrayList<>();
    row.add(TIME);
    row.addAll(heads);
    return line(row);
  }

  /** Row of a message recorded at a time [s since the start of the recording]. */
  String row(double timeS, U2SAData message) {
    Map<String, String> cells = cells(message);
    List<String> row = new ArrayList<>();
    row.add(String.format(Locale.ROOT, "%.6f", timeS));
    heads.forEach(head -> row.add(cells.getOrDefault(head, "")));
    return line(row);
  }

  private static Map<String, String> cells(U2SAData message) {
    Map<String, String> cells = new LinkedHashMap<>();
    for (FieldValue field : message.enumerateFields()) {
      Object value = field.value().orElse(null);
      if (value instanceof Point point) {
        cells.put(head(field.name() + ".x", field.unit()), Double.toString(point.x()));
        cells.put(head(field.name() + ".y", field.unit()), Double.toString(point.y()));
        cells.put(head(field.name() + ".z", field.unit()), Double.toString(point.z()));
      } else if (value != null) {
        cells.put(
            head(field.name(), field.unit()),
            value instanceof String words ? noFormula(words) : text(MessageJson.plain(value)));
      }
    }
    return cells;
  }

  private static String head(String name, String unit) {
    return unit.isEmpty() ? name : name + " [" + unit + "]";
  }

  /**
   * Prevents spreadsheets from evaluating a text, which may come from other people's services and
   * recordings. The leading apostrophe marks it as text and is not shown.
   */
  private static String noFormula(String text) {
    boolean isFormula = !text.isEmpty() && BEGINS_FORMULA.indexOf(text.charAt(0)) >= 0;
    return isFormula ? "'" + text : text;
  }

  private static String text(Object plain) {
    if (plain instanceof List<?>) {
      String object = new JsonText().put("a", plain).line();
      return object.substring(object.indexOf('['), object.length() - 1);
    }
    return plain instanceof JsonText json ? json.line() : String.valueOf(plain);
  }

  private static String line(List<String> cells) {
    StringBuilder line = new StringBuilder();
    for (String cell : cells) {
      line.append(line.length() == 0 ? "" : ",").append(cell(cell));
    }
    return line.append("\r\n").toString();
  }

  /** Text as a cell (RFC 4180): in quotes if it needs them. */
  static String cell(String text) {
    boolean needsQuotes = text.chars().anyMatch(c -> c == ',' || c == '"' || c < ' ');
    return needsQuotes ? '"' + text.replace("\"", "\"\"") + '"' : text;
  }
}
