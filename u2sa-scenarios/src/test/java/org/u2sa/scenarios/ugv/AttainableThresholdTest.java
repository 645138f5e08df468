package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.scenarios.run.CommandLineRun;

/** What receivers allow of a mission's thresholds is said, and thresholds can follow it. */
class AttainableThresholdTest {
  private static final Pattern REACHED =
      Pattern.compile("reached, passed at [0-9.]+ m \\(threshold ([0-9.]+) m\\)");

  @TempDir private Path directory;

  private CommandLineRun drive(String... options) {
    return CommandLineRun.demo("ugv", directory.resolve("out"), options);
  }

  private CommandLineRun driveOneWaypoint(String... options) {
    List<String> all = new ArrayList<>(List.of(options));
    all.addAll(List.of("--seed", "1", "--mission", OneWaypoint.in(directory).toString()));
    return drive(all.toArray(String[]::new));
  }

  private List<Double> thresholds(CommandLineRun run) throws IOException {
    return REACHED
        .matcher(Files.readString(run.directory().resolve("logs/PathPlanner.log")))
        .results()
        .map(each -> Double.parseDouble(each.group(1)))
        .toList();
  }

  @Test
  void demo_phoneReceiver_saysAtTheStartWhatItsThresholdsAreWorth() {
    CommandLineRun run = driveOneWaypoint("--receiver", "phone");

    assertThat(run.out())
        .contains("PathPlanner: waypoint \"1\" may be missed although it seems reached")
        .contains("its threshold of 0.5 m is truly met with a probability of");
  }

  @Test
  void demo_surveyReceiver_saysNothingOfThresholds() {
    assertThat(driveOneWaypoint().out()).doesNotContain("may be missed");
  }

  @ParameterizedTest
  @ValueSource(longs = 1)
  void demo_thresholdsFollowAPhonesAccuracy_areTrulyMet(long seed) throws IOException {
    CommandLineRun run =
        drive(
            "--receiver",
            "phone",
            "--loops",
            "2",
            "--seed",
            String.valueOf(seed),
            "--set",
            "PathPlanner:THRESHOLD SIGMAS=3");
    List<Double> thresholds = thresholds(run);
    JsonNode waypoints = run.summary().get("perWaypoint");
    assertThat(thresholds).hasSize(12).allSatisfy(each -> assertThat(each).isGreaterThan(1.0));
    int met = 0;
    for (int i = 0; i < thresholds.size(); i++) {
      met += waypoints.get(i).get("missM").asDouble() <= thresholds.get(i) ? 1 : 0;
    }
    assertThat(met).as(run.out()).isGreaterThanOrEqualTo(11); // 99 % are expected
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = 2)
  void demo_thresholdsFollowAPhonesAccuracyOtherSeed_areTrulyMet(long seed) throws IOException {
    demo_thresholdsFollowAPhonesAccuracy_areTrulyMet(seed);
  }

  @ParameterizedTest
  @ValueSource(longs = 1)
  void demo_sensorsAtTheBoardOnly_meetsTheMissionsThresholds(long seed) {
    UgvDemoTest.requireGood(
        drive("--sensors", "board", "--loops", "2", "--seed", String.valueOf(seed)), 12);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = {2, 3})
  void demo_sensorsAtTheBoardOnlyMoreSeeds_meetsTheMissionsThresholds(long seed) {
    demo_sensorsAtTheBoardOnly_meetsTheMissionsThresholds(seed);
  }
}
