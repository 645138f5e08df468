package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.Main;

/**
 * Code on the pages is code that is compiled and tested: files of the repository, and in the
 * tutorial what its own {@code u2sa new} commands make, which are run here in a home folder of
 * their own.
 */
class TutorialTest {
  /** A comment that names a file of the repository, and the fenced block after it. */
  private static final Pattern LISTING = block("<!-- file: (\\S+) -->");

  /** Likewise of a file in the reader's home folder. */
  private static final Pattern MADE = block("<!-- made: (\\S+) -->");

  /** What the last command before it printed. */
  private static final Pattern SAID = block("<!-- said (\\d+) -->");

  private static final Pattern COMMAND = Pattern.compile("(?m)^(cd|~/u2sa/u2sa new) (.+)$");

  @TempDir Path home;

  private static Pattern block(String comment) {
    return Pattern.compile("(" + comment + "\\n```\\w*\\n)(.*?)(```\\n)", Pattern.DOTALL);
  }

  private interface Source {
    String of(String name) throws IOException;
  }

  private static String with(String text, Pattern block, Source source) throws IOException {
    Matcher blocks = block.matcher(text);
    StringBuilder expected = new StringBuilder();
    while (blocks.find()) {
      String content = blocks.group(1) + source.of(blocks.group(2)) + blocks.group(4);
      blocks.appendReplacement(expected, Matcher.quoteReplacement(content));
    }
    return blocks.appendTail(expected).toString();
  }

  @ParameterizedTest
  @ValueSource(strings = {"docs/hot-swap.md", "docs/drivers/own.md", "docs/tutorial/vehicle.md"})
  void listings_areTheirFiles(String path) throws IOException {
    Page page = new Page(path);
    page.mustBe(with(page.text(), LISTING, file -> Files.readString(Page.ROOT.resolve(file))));
  }

  @ParameterizedTest
  @ValueSource(strings = {"first-sensor", "controller", "vehicle"})
  void tutorial_commandsRun_makeAndSayWhatThePageShows(String name) throws Exception {
    Page page = new Page("docs/tutorial/" + name + ".md");
    List<String> said = follow(page.text());
    assertThat(said).isNotEmpty();
    String shown = with(page.text(), MADE, file -> Files.readString(home.resolve(file)));
    page.mustBe(with(shown, SAID, number -> said.get(Integer.parseInt(number) - 1)));
  }

  /** Does what the page says as far as it makes files, and returns what was printed. */
  private List<String> follow(String text) throws IOException, InterruptedException {
    List<String> said = new ArrayList<>();
    Path here = home;
    Matcher commands = COMMAND.matcher(text);
    while (commands.find()) {
      String rest = commands.group(2);
      if (commands.group(1).equals("cd")) {
        here =
            rest.startsWith("~") ? home.resolve(rest.replaceFirst("^~/?", "")) : here.resolve(rest);
      } else {
        said.add(made(here, rest));
      }
    }
    return said;
  }

  private String made(Path here, String arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.addAll(List.of("-Du2sa.home=~/u2sa", "-cp", System.getProperty("java.class.path")));
    command.addAll(List.of(Main.class.getName(), "new"));
    command.addAll(List.of(arguments.split(" ")));
    Path output = home.resolve("output.txt");
    Process process =
        new ProcessBuilder(command)
            .directory(here.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor()).as(Files.readString(output)).isZero();
    return Files.readString(output);
  }
}
