package org.u2sa.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Damages XML files at random: odd numbers, other elements and words, lost text. */
public final class XmlMutations {
  private static final int MAX_CUT = 60; // characters
  private static final Pattern NUMBER = Pattern.compile("(?<=>|\\s)-?\\d+(\\.\\d+)?(?=<|\\s|;)");
  private static final Pattern TAG = Pattern.compile("</?\\w+");
  private static final Pattern WORD = Pattern.compile("(?<=>)[a-zA-Z][a-zA-Z -]*(?=<)");
  private static final List<String> ODD =
      List.of(
          "0", "-1", "1e-12", "1e12", "1e308", "NaN", "Infinity", "", "1 2", "x", "0.5", "-1e9");

  private final Random random;
  private final List<String> tags;
  private final List<String> words;

  /**
   * @param tags names by which elements are replaced
   * @param words texts by which texts are replaced
   */
  public XmlMutations(long seed, List<String> tags, List<String> words) {
    random = new Random(seed);
    this.tags = List.copyOf(tags);
    this.words = List.copyOf(words);
  }

  /** A copy with one to three defects. */
  public String of(String text) {
    String mutant = text;
    int defects = 1 + random.nextInt(3);
    for (int i = 0; i < defects; i++) {
      mutant =
          switch (random.nextInt(6)) {
            case 0, 1 -> replaced(mutant, NUMBER, one(ODD));
            case 2 -> replaced(mutant, NUMBER, "" + Math.exp(20.0 * random.nextGaussian()));
            case 3 -> replaced(mutant, TAG, "<" + one(tags));
            case 4 -> replaced(mutant, WORD, one(words));
            default -> cut(mutant);
          };
    }
    return mutant;
  }

  private String one(List<String> of) {
    return of.get(random.nextInt(of.size()));
  }

  private String replaced(String text, Pattern what, String by) {
    List<int[]> found = new ArrayList<>();
    Matcher matcher = what.matcher(text);
    while (matcher.find()) {
      found.add(new int[] {matcher.start(), matcher.end()});
    }
    if (found.isEmpty()) {
      return text;
    }
    int[] one = found.get(random.nextInt(found.size()));
    return text.substring(0, one[0]) + by + text.substring(one[1]);
  }

  private String cut(String text) {
    int from = random.nextInt(text.length());
    int to = Math.min(text.length(), from + 1 + random.nextInt(MAX_CUT));
    return text.substring(0, from) + text.substring(to);
  }
}
