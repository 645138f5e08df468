package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Main code and documents use today's words, and no Javadoc is damaged by a text replacement. */
class PlainWordsTest {
  private static final Pattern DATED =
      Pattern.compile(
          "\\b[Mm]aybe\\b|\\b(?i:anew|whither|thither|at will|none any more|such a one|it is said"
              + "|the one before|is there already|says otherwise|in vain|for ever|heeds|takes note)\\b"
              + "|\\b(?:MOST|LEAST)_[A-Z]" // MAX_ and MIN_
              + "|\\bso many (?:seconds|messages|bytes|times|metres|steps)\\b");

  private static final Pattern DAMAGED =
      Pattern.compile(
          "(?m)^\\s*\\* \\* |^\\s*(?:/\\*\\*|\\*) [^@\\n{}]*\\S @(?:param|throws|return) .*");

  @Test
  void mainCodeAndDocuments_asTheyStand_areInPlainWords() throws IOException {
    List<String> found = new ArrayList<>();
    for (Path file : texts()) {
      String text = Files.readString(file);
      find(DATED, file, text, found);
      if (file.toString().endsWith(".java") || file.toString().endsWith(".kt")) {
        find(DAMAGED, file, text, found);
      }
    }
    assertThat(found).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "The filter begins anew.",
        "int MOST_BYTES = 7;",
        "Waits so many seconds.",
        "Applies unless the file says otherwise.",
        "   * * Opens the pins.",
        "  /** Adds a channel. @return whether it could be opened */"
      })
  void patterns_sentenceOfThatKind_findIt(String text) {
    assertThat(DATED.matcher(text).find() || DAMAGED.matcher(text).find()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Uses AT_MOST_ONCE; so many small steps are fast.",
        "   * @param read number of pairs",
        "   * {@code @param}"
      })
  void patterns_anythingElse_isLeftAlone(String text) {
    assertThat(DATED.matcher(text).find() || DAMAGED.matcher(text).find()).isFalse();
  }

  private static List<Path> texts() throws IOException {
    List<Path> folders = new ArrayList<>(List.of(Page.ROOT.resolve("docs")));
    List<Path> found = new ArrayList<>(List.of(Page.ROOT.resolve("README.md")));
    try (Stream<Path> modules = Files.list(Page.ROOT)) {
      modules
          .map(module -> module.resolve("src/main"))
          .filter(Files::isDirectory)
          .forEach(folders::add);
    }
    for (Path folder : folders) {
      try (Stream<Path> files = Files.walk(folder)) {
        files.filter(PlainWordsTest::isText).forEach(found::add);
      }
    }
    return found;
  }

  private static boolean isText(Path file) {
    return file.toString().matches(".*\\.(?:java|kt|md)");
  }

  private static void find(Pattern pattern, Path file, String text, List<String> found) {
    Matcher matcher = pattern.matcher(text);
    while (matcher.find()) {
      found.add(Page.ROOT.relativize(file) + ": \"" + matcher.group().strip() + "\"");
    }
  }
}
