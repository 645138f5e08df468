package org.u2sa.scenarios.robosub;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.Repository;
import picocli.CommandLine;

/** Dives without a State Estimator, and with failures, with the shipped files, in lockstep. */
class RoboSubFailuresTest {
  @BeforeAll
  static void findFiles() {
    System.setProperty("u2sa.home", Repository.root().toString());
  }

  @TempDir private Path directory;

  private int dive(String... more) {
    String[] arguments = new String[more.length + 4];
    arguments[0] = "--out";
    arguments[1] = directory.resolve("run").toString();
    arguments[2] = "--seed";
    arguments[3] = "60";
    System.arraycopy(more, 0, arguments, 4, more.length);
    return new CommandLine(new RoboSubDemo()).execute(arguments);
  }

  private String read(String file) throws IOException {
    return Files.readString(directory.resolve("run").resolve(file));
  }

  @Test
  void demo_withoutEstimator_doesAllTasksWithoutContact() throws IOException {
    int status = dive("--without-estimator");

    assertThat(read("summary.json"))
        .containsPattern("\"goalsCompleted\" : 9")
        .containsPattern("\"pingersReached\" : 1")
        .containsPattern("\"surfacedInRing\" : 1")
        .containsPattern("\"contacts\" : 0");
    assertThat(status).isZero();
    assertThat(directory.resolve("run/logs/StateEstimator.log")).doesNotExist();
  }

  @Test
  void demo_velocityLogFails_risesAndSaysWhy() throws IOException {
    int status = dive("--change", "velocityLog/failsAt=15");

    assertThat(status).isNotZero();
    assertThat(read("summary.json")).contains("failsafe STOP: position");
    assertThat(read("logs/WaterSpeedSensor.log")).contains("lost");
    String[] track = read("track.csv").split("\n");
    double altitudeM = Double.parseDouble(track[track.length - 1].split(",")[3]);
    assertThat(altitudeM).as("at the surface").isGreaterThan(-0.3);
  }

  @Tag("long")
  @Test
  void demo_pingerFails_givesItUpAndDoesTheRest() throws IOException {
    dive("--change", "hydrophones/failsAt=1");

    assertThat(read("summary.json"))
        .contains("goal \\\"pinger\\\" abandoned")
        .containsPattern("\"goalsCompleted\" : 8");
  }

  @Tag("long")
  @Test
  void demo_thrusterDead_doesAllTasks() throws IOException {
    dive("--change", "vessel/thruster/forward=0.001", "--change", "vessel/thruster/reverse=0");

    assertThat(read("summary.json")).containsPattern("\"goalsCompleted\" : 9");
  }
}
