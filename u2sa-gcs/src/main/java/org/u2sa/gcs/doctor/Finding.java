package org.u2sa.gcs.doctor;

/**
 * What one check found.
 *
 * @param subject what was looked at
 * @param grade how it is
 * @param found what there is
 * @param advice what to do about it; empty if nothing
 */
record Finding(String subject, Grade grade, String found, String advice) {
  /** How it is, best first. */
  enum Grade {
    /** As it should be. */
    OK,
    /** Not there, and needed for some uses only. */
    OPTIONAL,
    /** Something will not work, or not well. */
    WARNING,
    /** Nothing runs like this. */
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
}
