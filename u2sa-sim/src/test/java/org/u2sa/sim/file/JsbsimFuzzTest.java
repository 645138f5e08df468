package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.testkit.XmlMutations;

/**
 * Mutated files of the trainer, its engine and its propeller: each ends in an error that names the
 * file, or in an aircraft that runs. {@code -Du2sa.fuzz=10000} makes more of them.
 */
class JsbsimFuzzTest {
  private static final int MUTATIONS = Integer.getInteger("u2sa.fuzz", 400) / 8;
  private static final Path SHIPPED = Path.of("../config/vehicles");
  private static final List<String> FILES =
      List.of(
          "trainer/trainer.xml",
          "trainer.xml",
          "trainer/trainer.xml",
          "trainer/engine/four90.xml",
          "trainer/trainer.xml",
          "trainer/engine/wood68.xml");

  private final XmlMutations mutations =
      new XmlMutations(30L, List.of("value", "table", "axis"), List.of("NONE", "LEFT"));

  private static boolean runs(Path folder) {
    try {
      VehicleFile file = VehicleFile.load(folder.resolve("trainer.xml"));
      VehicleRun run = new VehicleRun(file.make(file.emptyWorld(), Point.ORIGIN, 0.5, 1));
      file.model().actuators().forEach(each -> run.command(0, each, 0.6));
      assertThat(run.at(5_000_000).speedMps()).isFinite();
      return true;
    } catch (RunFailedException e) {
      assertThat(e.getMessage()).contains("diverged at");
      return false;
    } catch (BadInputException e) {
      assertThat(e.getMessage()).startsWith(folder.toString()).contains(".xml");
      return false;
    }
  }

  @Test
  void load_mutatedAircraft_runsOrIsRefusedWithItsFile(@TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("trainer/engine"));
    for (String each : FILES) {
      Files.writeString(folder.resolve(each), Vehicles.text(SHIPPED.resolve(each)));
    }
    assertThat(runs(folder)).isTrue();
    int running = 0;
    for (int i = 0; i < MUTATIONS; i++) {
      String name = FILES.get(i % FILES.size());
      String sound = Vehicles.text(SHIPPED.resolve(name));
      String mutant = mutations.of(sound);
      Files.writeString(folder.resolve(name), mutant);
      try {
        running += runs(folder) ? 1 : 0;
      } catch (RuntimeException | AssertionError e) {
        throw new AssertionError("mutant " + i + " of " + name + ":\n" + mutant, e);
      }
      Files.writeString(folder.resolve(name), sound);
    }
    assertThat(running).isBetween(MUTATIONS / 20, MUTATIONS - MUTATIONS / 20);
  }
}
