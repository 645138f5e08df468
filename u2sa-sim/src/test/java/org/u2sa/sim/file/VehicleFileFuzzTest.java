package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleRun;

/**
 * Mutated vehicle files: each ends in an error that names the file, or in a vehicle that runs.
 * {@code -Du2sa.fuzz=10000} makes more of them.
 */
class VehicleFileFuzzTest {
  private static final int MUTATIONS = Integer.getInteger("u2sa.fuzz", 400);
  private static final Pattern NUMBER = Pattern.compile("(?<=>|\\s)-?\\d+(\\.\\d+)?(?=<|\\s)");
  private static final Pattern TAG = Pattern.compile("</?\\w+");
  private static final List<String> ODD =
      List.of(
          "0", "-1", "1e-12", "1e12", "1e308", "NaN", "Infinity", "", "1 2", "x", "0.5", "-1e9");

  private final Random random = new Random(20);

  private String mutated(String text) {
    String mutant = text;
    for (int i = 0; i <= random.nextInt(3); i++) {
      mutant =
          switch (random.nextInt(5)) {
            case 0, 1 -> replaced(mutant, NUMBER, ODD.get(random.nextInt(ODD.size())));
            case 2 -> replaced(mutant, NUMBER, "" + Math.exp(20.0 * random.nextGaussian()));
            case 3 -> replaced(mutant, TAG, "<" + (random.nextBoolean() ? "mass" : "gps"));
            default -> cut(mutant);
          };
    }
    return mutant;
  }

  private String replaced(String text, Pattern what, String by) {
    List<int[]> found = new ArrayList<>();
    Matcher matcher = what.matcher(text);
    while (matcher.find()) {
      found.add(new int[] {matcher.start(), matcher.end()});
    }
    if (found.isEmpty()) {
      return text;
    }
    int[] one = found.get(random.nextInt(found.size()));
    return text.substring(0, one[0]) + by + text.substring(one[1]);
  }

  private String cut(String text) {
    int from = random.nextInt(text.length());
    int to = Math.min(text.length(), from + 1 + random.nextInt(60));
    return text.substring(0, from) + text.substring(to);
  }

  /** Whether it runs; false if it is refused. */
  private static boolean runs(String text) {
    try {
      VehicleFile file = Vehicles.parse(text);
      VehicleRun run = new VehicleRun(file.make(file.emptyWorld(), Point.ORIGIN, 0.5, 1));
      file.model().actuators().forEach(each -> run.command(0, each, 0.5));
      assertThat(run.at(5_000_000).speedMps()).isFinite();
      return true;
    } catch (RunFailedException e) {
      assertThat(e.getMessage()).contains("grew beyond all numbers at");
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
      String mutant = mutated(originals.get(i % originals.size()));
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
