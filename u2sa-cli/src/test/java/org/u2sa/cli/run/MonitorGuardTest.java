package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.health.HealthMonitor;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.planning.PathPlanner;
import org.u2sa.testkit.ServiceKit;

/** Which processes are restarted without an order, in a time that the test sets. */
@Timeout(120)
class MonitorGuardTest {
  private static final int KILLED = 137;

  @TempDir Path folder;
  private final ServiceKit kit = new ServiceKit();
  private final List<String> started = new ArrayList<>();
  private final List<String> said = new ArrayList<>();
  private final Set<String> dead = new HashSet<>();
  private ServiceNames names;
  private MonitorGuard guard;

  @BeforeEach
  void connect() throws IOException {
    Path file = folder.resolve("system.xml");
    Files.writeString(
        file,
        "<system id=\"kit\"><service class=\"%s\"/><service class=\"%s\"/><service class=\"%s\"/></system>"
            .formatted(
                PathPlanner.class.getName(),
                SafetyManager.class.getName(),
                HealthMonitor.class.getName()));
    KnownNames known = new KnownNames(new LaunchOptions());
    names =
        new ServiceNames(
            SystemFile.read(file), known, any -> true, kit.bus(), kit.clock(), said::add);
    guard =
        new MonitorGuard(
            names,
            kit.clock(),
            new MonitorGuard.Processes() {
              @Override
              public boolean isAlive(String entry) {
                return !dead.contains(entry);
              }

              @Override
              public void startProcess(String entry) {
                dead.remove(entry);
                started.add(entry);
              }
            },
            said::add);
    introduce("PathPlanner", PathPlanner.class, "PATH_PLANNER");
    introduce("SafetyManager", SafetyManager.class, "SAFETY_MANAGER");
    introduce("HealthMonitor", HealthMonitor.class, "HEALTH_MONITOR");
  }

  @AfterEach
  void close() {
    names.close();
    kit.close();
  }

  private void introduce(String name, Class<?> service, String role) {
    kit.publish(
        Channels.DISCOVERY,
        new DiscoveryResponse()
            .serviceName(name)
            .className(service.getName())
            .serviceType(role)
            .status(ServiceStatus.RUNNING));
  }

  private void monitorSpeaks() {
    kit.publish(
        Channels.HEALTH,
        new HealthReport()
            .serviceName("HealthMonitor")
            .status(ServiceStatus.RUNNING)
            .instance("m"));
  }

  private void end(String entry) {
    dead.add(entry);
    guard.ended(entry, KILLED);
  }

  @Test
  void ended_whileAMonitorSpeaks_isLeftToIt() {
    monitorSpeaks();

    end("PathPlanner");

    assertThat(started).isEmpty();
  }

  @Test
  void ended_withoutAMonitor_isRestartedAtOnceThreeTimes() {
    for (int i = 0; i < 4; i++) {
      end("PathPlanner");
      kit.advance(2.0);
    }

    assertThat(started).containsExactly("PathPlanner", "PathPlanner", "PathPlanner");
    assertThat(said)
        .containsExactly("Service PathPlanner keeps ending; giving up after three restarts.");

    kit.advance(60.0);
    end("PathPlanner");
    assertThat(started).hasSize(4);
  }

  @Test
  void ended_becauseItsInputIsBad_isNotRestarted() {
    dead.add("PathPlanner");
    guard.ended("PathPlanner", ExitCode.BAD_INPUT);

    assertThat(started).isEmpty();
  }

  @Test
  void ended_togetherWithTheMonitor_isRestartedWithIt() {
    monitorSpeaks();
    kit.advance(0.1);

    end("SafetyManager");
    end("HealthMonitor");

    assertThat(started).containsExactly("HealthMonitor", "SafetyManager");
  }

  @Test
  void ended_whileTheMonitorStarts_isRestartedAtOnce() {
    monitorSpeaks();
    kit.advance(0.1);

    end("HealthMonitor");
    end("SafetyManager");

    assertThat(started).containsExactly("HealthMonitor", "SafetyManager");
  }

  @Test
  void ended_longBeforeTheMonitor_isNotRestartedAgainstItsPolicy() {
    monitorSpeaks();
    end("PathPlanner");
    for (int i = 0; i < 10; i++) {
      kit.advance(0.5);
      monitorSpeaks();
      guard.look(kit.clock().micros());
    }

    end("HealthMonitor");

    assertThat(started).containsExactly("HealthMonitor");
  }

  @Test
  void monitor_silentForLong_isRestartedWithWhatItHasNotSeenTo() {
    monitorSpeaks();
    kit.advance(3.5);
    end("SafetyManager");
    kit.advance(1.0);

    guard.look(kit.clock().micros());

    assertThat(said).contains("Service HealthMonitor is silent.");
    assertThat(started).containsExactly("HealthMonitor", "SafetyManager");
  }

  @Test
  void learn_answerThatCallsAnotherServiceAMonitor_neverRestartsIt() {
    introduce("x3096", SafetyManager.class, "HEALTH_MONITOR");
    kit.publish(
        Channels.HEALTH,
        new HealthReport().serviceName("x3096").status(ServiceStatus.RUNNING).instance("x"));
    monitorSpeaks();
    for (int i = 0; i < 40; i++) {
      kit.advance(0.5);
      monitorSpeaks();
      guard.look(kit.clock().micros());
    }

    assertThat(started).isEmpty();
    assertThat(names.entryOf("x3096")).isEmpty();
    assertThat(names.nameOf("SafetyManager")).contains("SafetyManager");
  }

  @Test
  void learn_nameOfAnotherEntry_isRefused() {
    introduce("SafetyManager", PathPlanner.class, "PATH_PLANNER");

    assertThat(names.entryOf("SafetyManager")).contains("SafetyManager");
    assertThat(names.entryOf("PathPlanner")).contains("PathPlanner");
    assertThat(names.nameOf("PathPlanner")).contains("PathPlanner");
  }

  @Test
  void monitor_silentAfterEachRestart_isGivenUpAfterThree() {
    monitorSpeaks();
    for (int i = 0; i < 400; i++) {
      kit.advance(0.5);
      guard.look(kit.clock().micros());
    }

    assertThat(started).containsExactly("HealthMonitor", "HealthMonitor", "HealthMonitor");
    assertThat(said).filteredOn(line -> line.contains("giving up after three restarts")).hasSize(1);
  }
}
