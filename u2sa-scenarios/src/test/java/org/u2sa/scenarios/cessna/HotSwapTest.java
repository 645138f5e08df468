package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.control.fixedwing.CessnaControl;
import org.u2sa.control.fixedwing.ThesisControl;
import org.u2sa.planning.PathPlanner;
import org.u2sa.planning.VectorFieldPlanner;
import org.u2sa.scenarios.run.CommandLineRun;

/** Algorithms replaced in flight by the command line (thesis 5.1, user story 8). */
class HotSwapTest {
  @TempDir private Path directory;

  private static List<String> swap(double atS, String service, Class<?> type) {
    return List.of("--swap", atS + ":" + service + "=" + type.getName());
  }

  private CommandLineRun fly(String name, List<String> options) {
    return CommandLineRun.demo("cessna", directory.resolve(name), options.toArray(new String[0]));
  }

  private byte[] track(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name).resolve("track.csv"));
  }

  private List<String> shortMission(List<String> swaps) {
    List<String> options = new ArrayList<>(List.of("--seed", "5", "--wind", "6@30", "--mission"));
    options.add(ShortMission.in(directory).toString());
    options.addAll(swaps);
    return options;
  }

  @Test
  void swap_forTheSameClass_sameBytesOfTrackAsWithoutASwap() throws IOException {
    List<String> swaps = new ArrayList<>();
    for (double atS = 3.0; atS < 100.0; atS += 4.0) { // on the runway, in the climb, in cruise
      swaps.addAll(swap(atS, "Control", CessnaControl.class));
      swaps.addAll(swap(atS + 2.0, "PathPlanner", PathPlanner.class));
    }

    fly("without", shortMission(List.of()));
    CommandLineRun run = fly("with", shortMission(swaps));

    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
    assertThat(run.out()).contains("63.0 s: Control swapped");
    assertThat(track("with")).isEqualTo(track("without"));
  }

  @Tag("long")
  @Test
  void swap_forAnotherClass_sameBytesEachTime() throws IOException {
    List<String> swaps = new ArrayList<>(swap(40.0, "PathPlanner", VectorFieldPlanner.class));
    swaps.addAll(swap(80.0, "Control", ThesisControl.class));

    fly("once", shortMission(swaps));
    fly("again", shortMission(swaps));
    fly("without", shortMission(List.of()));

    assertThat(track("again")).isEqualTo(track("once"));
    assertThat(track("without")).isNotEqualTo(track("once"));
  }

  @Test
  void swap_unknownClass_isRefusedBeforeTheFlightInOneLine() {
    CommandLineRun run =
        fly("out", shortMission(List.of("--swap", "20:PathPlanner=org.example.Nothing")));

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--swap 20.0:", "org.example.Nothing", "not on the class path");
    assertThat(run.err().lines()).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource({"PathPlanner=x", "-1:PathPlanner=x", "soon:PathPlanner=x", "1:=x", "1:PathPlanner="})
  void swap_notOfThatForm_isRefusedBeforeTheFlight(String text) {
    CommandLineRun run = fly("out", List.of("--swap", text));

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("expected SECONDS:SERVICE=CLASS");
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void swap_plannerEveryFiveSecondsAndControlInCruise_keepsAllBounds(long seed) {
    List<String> options = new ArrayList<>(List.of("--seed", String.valueOf(seed)));
    for (int atS = 5; atS < 1_200; atS += 10) {
      options.addAll(swap(atS, "PathPlanner", VectorFieldPlanner.class));
      options.addAll(swap(atS + 5.0, "PathPlanner", PathPlanner.class));
    }
    for (int atS = 200; atS < 1_000; atS += 200) {
      options.addAll(swap(atS, "Control", ThesisControl.class));
      options.addAll(swap(atS + 5.0, "Control", CessnaControl.class));
    }

    CommandLineRun run = fly("out", options);

    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
    Summary.in(directory.resolve("out")).requireGood();
  }
}
