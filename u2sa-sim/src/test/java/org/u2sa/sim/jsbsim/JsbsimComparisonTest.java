package org.u2sa.sim.jsbsim;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.NeedsProgram;

/** JSBSim's own c172p, whose file may not be shipped, flown by JSBSim and by this package. */
@Tag("long")
class JsbsimComparisonTest {
  private static final Path SCRIPT = Path.of("../scripts/jsbsim/compare.py");

  @Test
  @NeedsProgram(value = "python3", modules = "jsbsim")
  void compare_c172pInFineSteps_allQuantitiesAgree(@TempDir Path folder)
      throws IOException, InterruptedException {
    Path table = folder.resolve("table.md");
    Process process =
        new ProcessBuilder(
                ForeignPrograms.ofThisMachine().required("python3", "jsbsim"),
                SCRIPT.toString(),
                "--substeps",
                "10",
                "--classes",
                System.getProperty("java.class.path"))
            .redirectErrorStream(true)
            .redirectOutput(table.toFile())
            .start();
    int exit = process.waitFor();
    String text = Files.readString(table);
    assertThat(exit).as(text).isZero();
    assertThat(text).contains("47 of 47 quantities");
  }
}
