package org.u2sa.gcs.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.File;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.gcs.Main;
import org.u2sa.gcs.services.Lidar;
import org.u2sa.testkit.FreePort;

/** What becomes of the services' processes when the one that started them is killed. */
@Timeout(240)
class ParentDeathTest {
  @TempDir private Path folder;

  private ProcessBuilder run(Path system) {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-cp",
            System.getProperty("java.class.path"),
            Main.class.getName(),
            "run",
            system.toString(),
            "--separate",
            "--logs",
            folder.resolve("logs").toString())
        .redirectInput(new File("/dev/null"))
        .redirectErrorStream(true);
  }

  @Test
  void separate_supervisorKilled_servicesEndAndTheNextRunHasTheirNames() throws Exception {
    Files.writeString(
        folder.resolve("Manager.xml"),
        "<configuration><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + FreePort.find()
            + "\"/></configuration>");
    Path system =
        Files.writeString(
            folder.resolve("system.xml"),
            "<system id=\"boat\"><communication configuration=\"Manager.xml\"/><service class=\""
                + Lidar.class.getName()
                + "\"/></system>");
    List<ProcessHandle> services = new ArrayList<>();
    Process supervisor = run(system).start();
    try {
      awaitLine(supervisor, "System boat runs: Lidar");
      supervisor.descendants().forEach(services::add);
      assertThat(services).hasSize(1);

      supervisor.toHandle().destroyForcibly(); // SIGKILL: no hook runs

      services.get(0).onExit().get(90, TimeUnit.SECONDS);
    } finally {
      supervisor.destroyForcibly().waitFor();
      services.forEach(ProcessHandle::destroyForcibly);
    }

    Process next = run(system).start();
    try {
      awaitLine(next, "System boat runs: Lidar");
    } finally {
      next.destroy(); // ends its services first
      next.waitFor();
    }
  }

  private static void awaitLine(Process process, String begin) throws Exception {
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    List<String> seen = new ArrayList<>();
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      seen.add(line);
      if (line.startsWith(begin)) {
        return;
      }
    }
    throw new AssertionError("ended without \"" + begin + "\": " + seen);
  }
}
