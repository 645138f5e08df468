package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Listings of the tutorial and of other pages are sources that are compiled and tested in
 * u2sa-core.
 */
class TutorialTest {
  /** A comment that names a file of the repository, and the fenced block after it. */
  private static final Pattern LISTING =
      Pattern.compile("(<!-- file: (\\S+) -->\\n```\\w*\\n)(.*?)(```\\n)", Pattern.DOTALL);

  private static final Path EXAMPLE =
      Page.ROOT.resolve("u2sa-core/src/test/java/org/u2sa/examples");

  @ParameterizedTest
  @ValueSource(strings = {"docs/tutorial.md", "docs/hot-swap.md", "docs/drivers/own.md"})
  void listings_areTheirFiles(String path) throws IOException {
    Page page = new Page(path);
    Matcher listings = LISTING.matcher(page.text());
    StringBuilder expected = new StringBuilder();
    while (listings.find()) {
      String file = Files.readString(Page.ROOT.resolve(listings.group(2)));
      listings.appendReplacement(
          expected, Matcher.quoteReplacement(listings.group(1) + file + listings.group(4)));
    }
    listings.appendTail(expected);
    page.mustBe(expected.toString());
  }

  @Test
  void listings_showTheWholeExample() throws IOException {
    List<String> shown = new ArrayList<>();
    LISTING
        .matcher(new Page("docs/tutorial.md").text())
        .results()
        .map((MatchResult listing) -> Path.of(listing.group(2)).getFileName().toString())
        .forEach(shown::add);
    try (var files = Files.list(EXAMPLE)) {
      assertThat(shown)
          .containsAll(
              files
                  .map(file -> file.getFileName().toString())
                  .filter(name -> !name.equals("package-info.java"))
                  .toList());
    }
  }
}
