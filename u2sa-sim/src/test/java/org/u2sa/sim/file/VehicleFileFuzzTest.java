package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.testkit.XmlMutations;

/**
 * Mutated vehicle files: each ends in an error that names the file, or in a vehicle that runs.
 * {@code -Du2sa.fuzz=10000} makes more of them.
 */
class VehicleFileFuzzTest {
  private static final int MUTATIONS = Integer.getInteger("u2sa.fuzz", 400);

  private final XmlMutations mutations =
      new XmlMutations(20L, List.of("mass", "gps"), List.of("clockwise"));

  /** Whether it runs; false if it is refused. */
  private static boolean runs(String text) {
    try {
      VehicleFile file = Vehicles.parse(text);
      VehicleRun run = new VehicleRun(file.make(file.emptyWorld(), Point.ORIGIN, 0.5, 1));
      file.model().actuators().forEach(each -> run.command(0, each, 0.5));
      assertThat(run.at(5_000_000).speedMps()).isFinite();
      return true;
    } catch (RunFailedException e) {
      assertThat(e.getMessage()).contains("diverged at");
      return false;
    } catch (BadInputException e) {
      assertThat(e.getMessage()).startsWith("vehicle.xml");
      return false;
    }
  }

  @Test
  void read_mutatedFiles_runOrAreRefusedWithTheirName() {
    List<String> originals =
        List.of(
            Vehicles.sixWheels(),
            Vehicles.threeThrusters(),
            Vehicles.text(Vehicles.MINI_MOLLE),
            Vehicles.text(Vehicles.OTTER),
            Vehicles.text(Vehicles.REMUS_100));
    int running = 0;
    for (int i = 0; i < MUTATIONS; i++) {
      String mutant = mutations.of(originals.get(i % originals.size()));
      try {
        running += runs(mutant) ? 1 : 0;
      } catch (RuntimeException | AssertionError e) {
        throw new AssertionError("mutant " + i + ":\n" + mutant, e);
      }
    }
    assertThat(running).isBetween(MUTATIONS / 20, MUTATIONS - MUTATIONS / 20);
  }

  @Test
  void load_shippedFiles_run() {
    for (Path file :
        List.of(Vehicles.MINI_MOLLE, Vehicles.BLUEROV2, Vehicles.OTTER, Vehicles.REMUS_100)) {
      assertThat(runs(Vehicles.text(file))).isTrue();
    }
  }
}
