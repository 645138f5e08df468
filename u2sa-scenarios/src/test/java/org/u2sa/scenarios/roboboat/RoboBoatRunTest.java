package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.Repository;
import picocli.CommandLine;

/** Whole runs with the shipped files, in lockstep, scored by the truth. */
class RoboBoatRunTest {
  @BeforeAll
  static void findFiles() {
    System.setProperty("u2sa.home", Repository.root().toString());
  }

  @TempDir private Path directory;

  private int sail(String... arguments) {
    return new CommandLine(new RoboBoatDemo())
        .execute(
            Stream.concat(
                    Stream.of(arguments), Stream.of("--out", directory.resolve("run").toString()))
                .toArray(String[]::new));
  }

  private String read(String file) throws IOException {
    return Files.readString(directory.resolve("run").resolve(file));
  }

  @Tag("long")
  @Test
  void demo_course401_passesAllGatesBothWaysWithoutContact() throws IOException {
    int status = sail("--seed", "401");

    assertThat(status).isZero();
    assertThat(read("judge.log"))
        .contains("speed gates: gate 2 of 2")
        .contains("channel: gate 15 of 15")
        .contains("return channel: gate 15 of 15");
    assertThat(read("summary.json"))
        .contains("\"contacts\" : 0", "\"homeInTime\" : 1", "\"tasksDone\" : 4");
  }

  @Test
  void demo_oneOfFourThrustersFails_passesAllGatesWithoutContactAndSaysSo() throws IOException {
    int status = sail("--seed", "402", "--holonomic", "--change", "vessel/thruster/failsAt=60");

    assertThat(status).isZero();
    assertThat(read("logs/Control.log")).contains("lost: LEFT REAR");
  }

  @Test
  void demo_tasksOnly_doesAllFour() throws IOException {
    sail("--seed", "7001", "--tasks-only");

    assertThat(read("summary.json")).contains("\"tasksDone\" : 4");
    assertThat(read("judge.log"))
        .contains("through the hoop", "touches button", "hot target reported")
        .contains("the quadrotor is back with the puck")
        .doesNotContain("touches dock", "touches puck", "touches wrong button");
  }

  @Tag("long")
  @Test
  void demo_cameraFailsInTheChannel_givesUpAndSaysWhy() throws IOException {
    int status = sail("--seed", "401", "--change", "detector/failsAt=45");

    assertThat(status).isNotZero();
    assertThat(read("logs/PathPlanner.log")).contains("given up");
    assertThat(read("summary.json")).contains("gates passed in order");
  }
}
