package org.u2sa.chaos;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.u2sa.testkit.Repository;

/**
 * Two hundred faults over one flight. Needs Mosquitto, ss, kill, a JDK and root; takes about half
 * an hour. -Du2sa.chaos.seed, -Du2sa.chaos.faults and -Du2sa.chaos.kinds choose others.
 */
@Tag("chaos")
class ChaosTest {
  @Test
  void fly_manyFaults_flightGoesOnAndNothingIsLostUnseen() throws Exception {
    long seed = Long.getLong("u2sa.chaos.seed", 1);
    int faults = Integer.getInteger("u2sa.chaos.faults", 200);
    Path folder = Paths.get("target", "chaos-" + seed).toAbsolutePath();
    deleteRecursively(folder);
    Files.createDirectories(folder);
    ChaosRun run = new ChaosRun(folder);

    run.fly(Repository.root(), seed, faults, kinds());

    assertThat(run.failures()).isEmpty();
  }

  private static List<Fault.Kind> kinds() {
    String names = System.getProperty("u2sa.chaos.kinds", "");
    return names.isEmpty()
        ? List.of(Fault.Kind.values())
        : Stream.of(names.split(",")).map(Fault.Kind::valueOf).toList();
  }

  private static void deleteRecursively(Path folder) throws Exception {
    if (Files.exists(folder)) {
      try (var files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }
}
