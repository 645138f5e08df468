package org.u2sa.interfaces.configuration;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.u2sa.interfaces.JsonText;

/**
 * A line of a configuration's audit log.
 *
 * @param revision revision after the change; for a failed change, the one it would have had
 * @param reason reason for rejection; empty if accepted
 * @param undoes revision of the change it undoes; empty if none
 */
record AuditEntry(
    long revision,
    ChangeOrigin origin,
    Outcome outcome,
    String reason,
    OptionalLong undoes,
    List<Value> values) {

  private static final JsonFactory JSON = new JsonFactory();

  enum Outcome {
    /** About to be written; successful unless a FAILED line with the same revision follows. */
    ACCEPTED,
    /** Rejected; no variable was changed. */
    REFUSED,
    /** An accepted change could not be written; the old values remain. */
    FAILED
  }

  /**
   * A changed variable.
   *
   * @param before in the declared unit; empty if unknown
   * @param after in the declared unit
   * @param textBefore in the file; empty if absent
   * @param textAfter in the file; empty if removed
   */
  record Value(
      String variable,
      Optional<String> before,
      String after,
      Optional<String> textBefore,
      Optional<String> textAfter) {}

  AuditEntry failed(String why) {
    return new AuditEntry(revision, origin, Outcome.FAILED, why, undoes, values);
  }

  /** Summary for a message: {@code "ann": "GAIN" 1.0 → 2.0 (revision 7)}. */
  String told() {
    String what =
        values.stream()
            .map(
                value ->
                    String.format(
                        "\"%s\" %s → %s",
                        value.variable(), value.before().orElse("?"), value.after()))
            .collect(Collectors.joining(", "));
    String who = origin.author().isEmpty() ? "an unnamed client" : "\"" + origin.author() + "\"";
    return who + ": " + what + " (revision " + revision + ")";
  }

  String line() {
    List<JsonText> changes = new ArrayList<>();
    for (Value value : values) {
      changes.add(
          new JsonText()
              .put("variable", value.variable())
              .put("old", value.before())
              .put("new", value.after())
              .put("oldText", value.textBefore())
              .put("newText", value.textAfter()));
    }
    return new JsonText()
        .put("revision", revision)
        .put("time", Instant.EPOCH.plus(origin.micros(), ChronoUnit.MICROS).toString())
        .put("service", origin.service())
        .put("author", origin.author())
        .put("outcome", outcome.name())
        .put("reason", Optional.of(reason).filter(why -> !why.isEmpty()))
        .put("undoes", undoes)
        .put("changes", changes)
        .line();
  }

  /** Empty if the line is invalid: truncated by a power cut, or edited by hand. */
  static Optional<AuditEntry> read(String line) {
    try (JsonParser json = JSON.createParser(line)) {
      if (json.nextToken() != JsonToken.START_OBJECT) {
        return Optional.empty();
      }
      List<Value> values = new ArrayList<>();
      Map<String, String> fields = fields(json, values);
      String undoes = fields.get("undoes");
      return Optional.of(
          new AuditEntry(
              Long.parseLong(required(fields, "revision")),
              new ChangeOrigin(
                  ChronoUnit.MICROS.between(Instant.EPOCH, Instant.parse(required(fields, "time"))),
                  fields.getOrDefault("service", ""),
                  fields.getOrDefault("author", "")),
              Outcome.valueOf(required(fields, "outcome")),
              fields.getOrDefault("reason", ""),
              undoes == null ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(undoes)),
              values));
    } catch (IOException | IllegalArgumentException | DateTimeException e) {
      return Optional.empty(); // invalid lines are skipped, as documented
    }
  }

  private static Map<String, String> fields(JsonParser json, List<Value> values)
      throws IOException {
    Map<String, String> fields = new HashMap<>();
    while (json.nextToken() == JsonToken.FIELD_NAME) {
      String name = json.currentName();
      JsonToken token = json.nextToken();
      if (token == JsonToken.START_ARRAY && name.equals("changes")) {
        while (json.nextToken() == JsonToken.START_OBJECT) {
          values.add(value(fields(json, new ArrayList<>())));
        }
      } else {
        fields.put(name, json.getText());
        json.skipChildren();
      }
    }
    if (json.currentToken() != JsonToken.END_OBJECT) {
      throw new IllegalArgumentException("the line ends too early");
    }
    return fields;
  }

  private static Value value(Map<String, String> fields) {
    return new Value(
        required(fields, "variable"),
        Optional.ofNullable(fields.get("old")),
        required(fields, "new"),
        Optional.ofNullable(fields.get("oldText")),
        Optional.ofNullable(fields.get("newText")));
  }

  private static String required(Map<String, String> fields, String name) {
    String text = fields.get(name);
    if (text == null) {
      throw new IllegalArgumentException("\"" + name + "\" is missing");
    }
    return text;
  }
}
