package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.services.Lidar;
import org.u2sa.core.health.HealthMonitor;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.ProcessTree;

/**
 * Processes of {@code --separate}: how they end with the one that started them, and it with them.
 */
@Timeout(240)
class SeparateProcessesTest {
  @TempDir private Path folder;
  private String broker;

  private ProcessBuilder run(Path system, String... options) {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "run",
                system.toString(),
                "--separate",
                "--logs",
                folder.resolve("logs").toString()));
    command.addAll(List.of(options));
    return new ProcessBuilder(command)
        .redirectInput(new File("/dev/null"))
        .redirectErrorStream(true);
  }

  private Path system(Class<?>... services) throws IOException {
    int port = FreePort.find();
    broker = "127.0.0.1:" + port;
    Files.writeString(
        folder.resolve("Manager.xml"),
        "<configuration><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + port
            + "\"/></configuration>");
    StringBuilder text =
        new StringBuilder("<system id=\"boat\"><communication configuration=\"Manager.xml\"/>");
    for (Class<?> service : services) {
      text.append("<service class=\"").append(service.getName()).append("\"/>");
    }
    return Files.writeString(folder.resolve("system.xml"), text.append("</system>"));
  }

  @Test
  void separate_valueThatAServiceRefuses_endsAllAsBadInput() throws Exception {
    Path system = system(Lidar.class, HealthMonitor.class);
    Process run = run(system, "--set", "HealthMonitor:NO SUCH VARIABLE=1").start();
    try {
      String said = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

      assertThat(run.waitFor()).as(said).isEqualTo(ExitCode.BAD_INPUT);
      assertThat(said).contains("NO SUCH VARIABLE").contains("The system is ending");
    } finally {
      ProcessTree.kill(run);
    }
  }

  @Test
  void separate_supervisorKilled_servicesEndAndTheNextRunHasTheirNames() throws Exception {
    Path system = system(Lidar.class);
    List<ProcessHandle> services = new ArrayList<>();
    Process supervisor = run(system).start();
    try {
      awaitLine(supervisor, "System boat is running: Lidar");
      supervisor.descendants().forEach(services::add);
      assertThat(services).hasSize(1);

      supervisor.toHandle().destroyForcibly(); // SIGKILL: no hook runs

      services.get(0).onExit().get(90, TimeUnit.SECONDS);
    } finally {
      ProcessTree.kill(supervisor);
      services.forEach(ProcessHandle::destroyForcibly);
    }

    Process next = run(system).start();
    try {
      awaitLine(next, "System boat is running: Lidar");
    } finally {
      ProcessTree.end(next); // ends its services first
    }
  }

  @Test
  void separate_serviceKilledWithoutAMonitor_isRestarted() throws Exception {
    Process supervisor = run(system(Lidar.class, SafetyManager.class)).start();
    try {
      awaitLine(supervisor, "System boat is running");
      supervisor.descendants().findFirst().orElseThrow().destroyForcibly();

      awaitLine(supervisor, line -> line.matches("Service \\w+ was restarted\\."));
    } finally {
      ProcessTree.end(supervisor); // ends its services first
    }
  }

  @Tag("long")
  @Test
  void separate_onlyServiceKilled_systemGoesOnWithTheNext() throws Exception {
    Process supervisor = run(system(Lidar.class)).start();
    try {
      awaitLine(supervisor, "System boat is running: Lidar");
      supervisor.descendants().findFirst().orElseThrow().destroyForcibly();

      List<String> restarted = new ArrayList<>();
      awaitLine(
          supervisor,
          line -> {
            if (line.equals("Service Lidar was restarted.")) {
              restarted.add(line);
            }
            return !restarted.isEmpty() && line.startsWith("System boat is running: Lidar");
          });
    } finally {
      ProcessTree.end(supervisor); // ends its services first
    }
  }

  @Test
  void stop_serviceIsStillStarting_endsTheSystemToo() throws Exception {
    Path gate = folder.resolve("gate");
    ProcessBuilder run = run(system(Latecomer.class));
    run.environment().put(Latecomer.GATE, gate.toString());
    Process supervisor = run.start();
    StringWriter said = new StringWriter();
    try {
      awaitLine(supervisor, "System boat is running in processes");

      PrintWriter out = new PrintWriter(said);
      int exitCode = Main.run(out, out, "stop", "--broker", broker, "--timeout", "60");
      Files.createFile(gate);

      assertThat(exitCode).as(said.toString()).isEqualTo(ExitCode.DONE);
      assertThat(supervisor.waitFor(60, TimeUnit.SECONDS)).as("ended").isTrue();
    } finally {
      ProcessTree.end(supervisor); // ends its services first
    }
  }

  @Test
  void restart_serviceThatWorks_isReleasedBeforeItEnds() throws Exception {
    Path system = system(Winch.class);
    Process supervisor = run(system).start();
    StringWriter said = new StringWriter();
    try {
      awaitLine(supervisor, "System boat is running: Winch");

      PrintWriter out = new PrintWriter(said);
      int exitCode = Main.run(out, out, "restart", "Winch", "--broker", broker, "--timeout", "60");

      assertThat(exitCode).as(said.toString()).isEqualTo(ExitCode.DONE);
      assertThat(folder.resolve("logs").resolve(Winch.RELEASED)).hasContent("released");
    } finally {
      ProcessTree.end(supervisor); // ends its services first
    }
  }

  @Test
  void restart_fenceFileBrokenMeanwhile_isRefusedAndTheProcessRunsOn() throws Exception {
    String corners =
        "<corner><x>0</x><y>0</y></corner><corner><x>9</x><y>0</y></corner><corner><x>0</x><y>9</y></corner>";
    Path fence =
        Files.writeString(
            folder.resolve("fence.xml"),
            "<fence><reference>Local ENU</reference><keepIn>" + corners + "</keepIn></fence>");
    Process supervisor =
        run(system(SafetyManager.class), "--set", "SafetyManager:FENCE=" + fence).start();
    StringWriter said = new StringWriter();
    try {
      awaitLine(supervisor, "System boat is running: SafetyManager");
      ProcessHandle before = supervisor.descendants().findFirst().orElseThrow();
      PrintWriter out = new PrintWriter(said);
      int works = Main.run(out, out, "services", "--broker", broker, "--timeout", "60");
      assertThat(works).as(said.toString()).isEqualTo(ExitCode.DONE);
      Files.writeString(fence, "<fence/>");

      int exitCode =
          Main.run(out, out, "restart", "SafetyManager", "--broker", broker, "--timeout", "60");

      assertThat(exitCode).as(said.toString()).isNotEqualTo(ExitCode.DONE);
      assertThat(said.toString()).contains("fence.xml");
      assertThat(supervisor.descendants()).containsExactly(before);
    } finally {
      ProcessTree.end(supervisor); // ends its services first
    }
  }

  private static void awaitLine(Process process, String begin) throws Exception {
    awaitLine(process, line -> line.startsWith(begin));
  }

  private static void awaitLine(Process process, Predicate<String> wanted) throws Exception {
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    List<String> seen = new ArrayList<>();
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      seen.add(line);
      if (wanted.test(line)) {
        return;
      }
    }
    throw new AssertionError("ended without the wanted line: " + seen);
  }
}
