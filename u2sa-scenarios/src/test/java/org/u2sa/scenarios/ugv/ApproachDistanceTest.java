package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Pursuit control slows down within APPROACH DISTANCE of the navigation point, which the planner
 * places LOOK AHEAD in front: if that is nearer, the vehicle never drives at its speed.
 */
class ApproachDistanceTest {
  private static final Path FOLDER = Path.of("..", "config", "ugv");

  static List<Path> systems() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files
          .filter(file -> file.getFileName().toString().matches("system.*\\.xml"))
          .filter(file -> text(file).contains("PursuitControl"))
          .sorted()
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource("systems")
  void approachDistance_ofEachSystem_isBelowLookAhead(Path system) {
    double approach = variable(system, "PursuitControl", "APPROACH DISTANCE");
    double lookAhead = variable(system, "PathPlanner", "LOOK AHEAD");

    assertThat(approach).isLessThan(lookAhead);
  }

  private static double variable(Path system, String service, String name) {
    String file = group(text(system), service + "\" configuration=\"([^\"]+)\"");
    String value = group(text(FOLDER.resolve(file)), "\"" + name + "\"[^>]* value=\"([^\"]+)\"");
    return Double.parseDouble(value);
  }

  private static String group(String text, String pattern) {
    Matcher matcher = Pattern.compile(pattern).matcher(text);
    assertThat(matcher.find()).as(pattern).isTrue();
    return matcher.group(1);
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
