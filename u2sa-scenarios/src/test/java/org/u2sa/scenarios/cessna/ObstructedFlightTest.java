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
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/**
 * Towers and keep-out zones that the World Modeler has from a file, traffic that only a receiver
 * hears, and a planner that leads the aircraft around both, on noisy sensors. Judged by truth.
 */
class ObstructedFlightTest {
  /** On the line of the short mission: a tower, and an aeroplane that comes the other way. */
  private static final String ON_THE_LINE =
      """
      <world>
        <Cylinder><uid>tower</uid><x>-157.905</x><y>21.325239</y><z>200</z><radius>150</radius><height>400</height></Cylinder>
        <MovingSphere><uid>N1</uid><type>aircraft</type><x>-157.845</x><y>21.325239</y><z>152.4</z><radius>150</radius>
          <xDot>-25</xDot><yDot>0</yDot></MovingSphere>
      </world>
      """;

  @TempDir private Path directory;

  private CommandLineRun fly(Path world, String... more) {
    List<String> all = new ArrayList<>(List.of("--world", world.toString()));
    all.addAll(List.of(more));
    return CommandLineRun.demo("cessna", directory.resolve("out"), all.toArray(new String[0]));
  }

  private Path file(String world) throws IOException {
    return Files.writeString(directory.resolve("world.xml"), world);
  }

  private String mission() {
    return ShortMission.in(directory, "-157.910168", "-157.880000").toString();
  }

  @Test
  void demo_towerAndTrafficOnTheLine_areFlownAround() throws IOException {
    CommandLineRun run =
        fly(file(ON_THE_LINE), "--mission", mission(), "--wind", "5@180", "--seed", "3");
    Summary summary = Summary.in(directory.resolve("out"));
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(summary.numbers("leastDistanceM")).hasSize(2).allMatch(least -> least > 5.5);
    assertThat(summary.number("violations")).isZero();
  }

  @Tag("long")
  @Test
  void demo_plannerThatSeesNothing_touchesBothAndFails() throws IOException {
    CommandLineRun run =
        fly(
            file(ON_THE_LINE),
            "--mission",
            mission(),
            "--wind",
            "5@180",
            "--seed",
            "3",
            "--set",
            "PathPlanner:PLANNER=NONE");
    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    Summary summary = Summary.in(directory.resolve("out"));
    assertThat(summary.number("violations")).isEqualTo(2.0);
    assertThat(run.out()).contains("TOUCHED").contains("violation: entered tower");
  }

  @Test
  void demo_noSuchWorld_isRefusedNamingTheFile() {
    CommandLineRun run = fly(directory.resolve("none.xml"));
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("none.xml");
  }

  @Test
  void demo_wrongWorld_isRefusedNamingFileAndLine() throws IOException {
    CommandLineRun run =
        fly(
            file(
                "<world>\n<Cylinder><x>1</x><y>2</y><radius>wide</radius></Cylinder>\n</world>\n"));
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("world.xml, line 2").contains("wide");
  }

  @Test
  void demo_worldOnTheSimulatorsTruth_isRefused() throws IOException {
    CommandLineRun run = fly(file(ON_THE_LINE), "--estimator", "pass_through");
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--world: expected --estimator fusing");
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
  void demo_wholeMission_everyWaypointAndNoViolation(long seed) {
    Path world = Repository.root().resolve("missions/cessna/obstructed.xml");
    CommandLineRun run = fly(world, "--seed", String.valueOf(seed));
    Summary summary = Summary.in(directory.resolve("out"));
    assertThat(run.exitCode()).as("seed %d: %s%s", seed, run.err(), summary).isZero();
    assertThat(summary.number("waypointsCaptured")).isEqualTo(10.0);
    assertThat(summary.worstMissM()).isLessThanOrEqualTo(100.0);
    assertThat(summary.numbers("leastDistanceM")).hasSize(12).allMatch(least -> least > 5.5);
    assertThat(summary.number("altitudeMaxErrorM")).isLessThanOrEqualTo(30.0);
    assertThat(summary.number("maxBankDeg")).isLessThanOrEqualTo(35.0);
    assertThat(summary.flag("stalled")).isFalse();
  }
}
