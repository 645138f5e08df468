package org.u2sa.interfaces.configuration;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * A line of a configuration's audit log.
 *
 * @param revision of the configuration after it; of a failed change, the one that it would have had
 * @param origin who and when
 * @param outcome what came of it
 * @param reason why not; empty if accepted
 * @param undoes revision of the change that it takes back; empty if it takes none back
 * @param values what was changed
 */
record AuditEntry(
    long revision,
    ChangeOrigin origin,
    Outcome outcome,
    String reason,
    OptionalLong undoes,
    List<Value> values) {

  /** What came of a change. */
  enum Outcome {
    /** About to be written; it was, unless a line FAILED of the same revision follows. */
    ACCEPTED,
    /** Nothing was changed. */
    REFUSED,
    /** What was accepted could not be written: the old values stand. */
    FAILED
  }

  /**
   * One variable.
   *
   * @param variable its name
   * @param before its value before, in the declared unit; empty if it is unknown
   * @param after its value after, in the declared unit
   * @param textBefore the file's text before; empty if the file did not have the variable
   * @param textAfter the file's text after; empty if the file does not have it any longer
   */
  record Value(
      String variable,
      Optional<String> before,
      String after,
      Optional<String> textBefore,
      Optional<String> textAfter) {}

  /** The entry for what was not changed after all. */
  AuditEntry failed(String why) {
    return new AuditEntry(revision, origin, Outcome.FAILED, why, undoes, values);
  }

  /** Who changed what, for a message: {@code "ann": "GAIN" 1.0 → 2.0 (revision 7)}. */
  String told() {
    String what =
        values.stream()
            .map(
                value ->
                    String.format(
                        "\"%s\" %s → %s",
                        value.variable(), value.before().orElse("?"), value.after()))
            .collect(Collectors.joining(", "));
    String who = origin.author().isEmpty() ? "somebody" : "\"" + origin.author() + "\"";
    return who + ": " + what + " (revision " + revision + ")";
  }
}
