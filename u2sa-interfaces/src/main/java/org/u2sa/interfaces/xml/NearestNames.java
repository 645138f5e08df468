package org.u2sa.interfaces.xml;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Suggests the name a user most likely meant, for error messages. */
public final class NearestNames {
  private NearestNames() {}

  /**
   * Known name with the smallest edit distance, ignoring case; empty if more than a third of its
   * letters differ.
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
    return best != null && fewest * 3 <= best.length() ? Optional.of(best) : Optional.empty();
  }

  /** {@code "; did you mean "x"?"}, or nothing if no known name is near. */
  public static String didYouMean(String given, Collection<String> known) {
    return nearest(given, known).map(name -> "; did you mean \"" + name + "\"?").orElse("");
  }

  // Optimal string alignment distance (Damerau 1964), which counts a transposition, the most common
  // typo, as one edit.
  private static int edits(String from, String to) {
    int[][] edits = new int[from.length() + 1][to.length() + 1];
    for (int i = 0; i <= from.length(); i++) {
      for (int j = 0; j <= to.length(); j++) {
        if (i == 0 || j == 0) {
          edits[i][j] = i + j;
          continue;
        }
        boolean same = from.charAt(i - 1) == to.charAt(j - 1);
        int fewest = edits[i - 1][j - 1] + (same ? 0 : 1);
        fewest = Math.min(fewest, Math.min(edits[i - 1][j], edits[i][j - 1]) + 1);
        if (i > 1
            && j > 1
            && from.charAt(i - 1) == to.charAt(j - 2)
            && from.charAt(i - 2) == to.charAt(j - 1)) {
          fewest = Math.min(fewest, edits[i - 2][j - 2] + 1);
        }
        edits[i][j] = fewest;
      }
    }
    return edits[from.length()][to.length()];
  }
}
