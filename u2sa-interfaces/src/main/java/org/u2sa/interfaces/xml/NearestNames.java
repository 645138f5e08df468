package org.u2sa.interfaces.xml;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Finds the name that a user most likely meant, for the end of an error message. */
public final class NearestNames {
  private NearestNames() {}

  /**
   * The known name that needs the fewest edits from {@code given}, case aside; empty if even that
   * one differs in more than a third of its letters.
   */
  public static Optional<String> nearest(String given, Collection<String> known) {
    String wanted = given.toLowerCase(Locale.ROOT);
    String best = null;
    int fewest = Integer.MAX_VALUE;
    for (String name : known) {
      int edits = edits(wanted, name.toLowerCase(Locale.ROOT));
      if (edits < fewest) {
        fewest = edits;
        best = name;
      }
    }
    return best != null && fewest * 3 <= Math.max(best.length(), 3)
        ? Optional.of(best)
        : Optional.empty();
  }

  /** {@code "; did you mean "x"?"}, or nothing if no known name is near. */
  public static String didYouMean(String given, Collection<String> known) {
    return nearest(given, known).map(name -> "; did you mean \"" + name + "\"?").orElse("");
  }

  // Levenshtein's distance, one row at a time (Wagner & Fischer 1974).
  private static int edits(String from, String to) {
    int[] row = new int[to.length() + 1];
    for (int j = 0; j <= to.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= from.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= to.length(); j++) {
        int replaced = diagonal + (from.charAt(i - 1) == to.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, Math.min(row[j], row[j - 1]) + 1);
      }
    }
    return row[to.length()];
  }
}
