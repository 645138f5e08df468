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

/** Whole dives with the shipped files, in lockstep. */
class RoboSubRunTest {
  @BeforeAll
  static void findFiles() {
    System.setProperty("u2sa.home", Repository.root().toString());
  }

  @TempDir private Path directory;

  private int dive(String... more) {
    String[] arguments = new String[more.length + 2];
    arguments[0] = "--out";
    arguments[1] = directory.resolve("run").toString();
    System.arraycopy(more, 0, arguments, 2, more.length);
    return new CommandLine(new RoboSubDemo()).execute(arguments);
  }

  private String read(String file) throws IOException {
    return Files.readString(directory.resolve("run").resolve(file));
  }

  @Test
  void demo_randomLayout_doesAllTasksAndKnowsItsDepth() throws IOException {
    int status = dive("--seed", "41");

    assertThat(status).isZero();
    assertThat(read("summary.json"))
        .containsPattern("\"tasksDone\" ?: ?8")
        .containsPattern("\"buoysBumpedInOrder\" ?: ?2")
        .containsPattern("\"markersInBin\" ?: ?2")
        .containsPattern("\"torpedoesThroughHoop\" ?: ?2")
        .containsPattern("\"surfacedInRing\" ?: ?1")
        .containsPattern("\"worstDepthErrorMetres\" ?: ?0\\.0");
  }

  @Tag("long")
  @Test
  void demo_cameraFailsAtTheStart_givesUpAndSaysWhy() throws IOException {
    int status = dive("--seed", "41", "--change", "detector/failsAt=1");

    assertThat(status).isNotZero();
    assertThat(read("logs/PathPlanner.log")).contains("abandoned");
    assertThat(read("judge.log")).doesNotContain("touches");
  }
}
