package org.u2sa.gcs;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * What a mistyped command, option or name may have been meant to be. picocli's own suggestions miss
 * swapped letters.
 */
public final class Suggestions {

  private static final int MOST = 3;

  private Suggestions() {}

  /** The commands or options nearest to what {@code e} could not match; empty if none is near. */
  static List<String> of(UnmatchedArgumentException e) {
    String typed = e.getUnmatched().get(0).replaceFirst("=.*", "");
    CommandLine command = e.getCommandLine();
    Collection<String> known =
        typed.startsWith("-")
            ? command.getCommandSpec().optionsMap().keySet()
            : command.getSubcommands().keySet();
    return nearest(typed, known);
  }

  /** The names nearest to what was typed, nearest first, at most three; empty if none is near. */
  public static List<String> nearest(String typed, Collection<String> known) {
    int most = 1 + typed.length() / 4;
    return known.stream()
        .filter(
            name -> distance(typed, name) <= most || typed.length() > 2 && name.startsWith(typed))
        .sorted(
            Comparator.comparingInt((String name) -> distance(typed, name))
                .thenComparing(name -> name))
        .limit(MOST)
        .toList();
  }

  /**
   * Least number of letters to insert, delete, replace or swap with their neighbour (optimal string
   * alignment).
   */
  private static int distance(String a, String b) {
    int[][] d = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int k = 0; k <= b.length(); k++) {
        if (i == 0 || k == 0) {
          d[i][k] = i + k;
          continue;
        }
        int replaced = d[i - 1][k - 1] + (a.charAt(i - 1) == b.charAt(k - 1) ? 0 : 1);
        d[i][k] = Math.min(replaced, 1 + Math.min(d[i - 1][k], d[i][k - 1]));
        if (i > 1
            && k > 1
            && a.charAt(i - 1) == b.charAt(k - 2)
            && a.charAt(i - 2) == b.charAt(k - 1)) {
          d[i][k] = Math.min(d[i][k], 1 + d[i - 2][k - 2]);
        }
      }
    }
    return d[a.length()][b.length()];
  }
}
