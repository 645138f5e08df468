package org.u2sa.gcs.dependencies;

/**
 * A published weakness.
 *
 * @param library group:artifact, or group:* for all of a group
 * @param introduced first version that has it
 * @param fixed first version that has it no more, or "never"
 * @param reached whether our use of the library comes to it
 */
record Advisory(
    String id, String library, String introduced, String fixed, boolean reached, String what) {
  private static final String NEVER = "never";
  private static final String ALL = ":*";

  boolean affects(Library used) {
    boolean same =
        library.endsWith(ALL)
            ? used.name().startsWith(library.substring(0, library.length() - ALL.length() + 1))
            : used.name().equals(library);
    return same
        && compare(used.version(), introduced) >= 0
        && (fixed.equals(NEVER) || compare(used.version(), fixed) < 0);
  }

  /** By numbers, part by part; words such as Final count for nothing. */
  static int compare(String one, String other) {
    String[] left = one.split("[.-]");
    String[] right = other.split("[.-]");
    for (int i = 0; i < Math.max(left.length, right.length); i++) {
      int difference = Integer.compare(number(left, i), number(right, i));
      if (difference != 0) {
        return difference;
      }
    }
    return 0;
  }

  private static int number(String[] parts, int index) {
    return index < parts.length && parts[index].matches("\\d{1,9}")
        ? Integer.parseInt(parts[index])
        : 0;
  }
}
