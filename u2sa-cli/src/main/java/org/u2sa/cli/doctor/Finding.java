package org.u2sa.cli.doctor;

import org.u2sa.interfaces.JsonText;

/**
 * Result of one check.
 *
 * @param subject subject of the check
 * @param grade assessment
 * @param found the observation
 * @param advice remedy; empty if none is needed
 */
record Finding(String subject, Grade grade, String found, String advice) {
  /** Assessment, best first. */
  enum Grade {
    OK,
    /** Missing, but only needed for some uses. */
    OPTIONAL,
    /** Something will not work well or at all. */
    WARNING,
    /** Nothing will run. */
    FAILURE
  }

  static Finding ok(String subject, String found) {
    return new Finding(subject, Grade.OK, found, "");
  }

  static Finding optional(String subject, String found, String advice) {
    return new Finding(subject, Grade.OPTIONAL, found, advice);
  }

  static Finding warning(String subject, String found, String advice) {
    return new Finding(subject, Grade.WARNING, found, advice);
  }

  static Finding failure(String subject, String found, String advice) {
    return new Finding(subject, Grade.FAILURE, found, advice);
  }

  JsonText json() {
    return new JsonText()
        .put("subject", subject)
        .put("grade", grade.name())
        .put("found", found)
        .put("advice", advice);
  }
}
