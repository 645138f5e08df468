package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.control.fixedwing.CessnaControl;
import org.u2sa.core.health.HealthMonitor;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.planning.PathPlanner;
import org.u2sa.testkit.ServiceKit;

/** Whose name is whose, whatever is answered to discovery. */
@Timeout(120)
class ServiceNamesTest {
  @TempDir Path folder;
  private final ServiceKit kit = new ServiceKit();
  private final List<String> said = new ArrayList<>();
  private final Set<String> own =
      Set.of("SafetyManager", "HealthMonitor", "PathPlanner", "Way", "Control", "x");
  private ServiceNames names;

  @AfterEach
  void close() {
    names.close();
    kit.close();
  }

  private void names(LaunchOptions options) throws IOException {
    Files.writeString(
        folder.resolve("Planner.xml"),
        "<configuration><variable name=\"SERVICE NAME\" type=\"string\" value=\"Way\"/>"
            + "<variable name=\"OTHER\" type=\"int\" value=\"1\"/></configuration>");
    Path file =
        Files.writeString(
            folder.resolve("system.xml"),
            "<system id=\"kit\"><service class=\"%s\" configuration=\"Planner.xml\"/><service class=\"%s\"/><service class=\"%s\"/><service class=\"%s\"/></system>"
                .formatted(
                    PathPlanner.class.getName(),
                    CessnaControl.class.getName(),
                    SafetyManager.class.getName(),
                    HealthMonitor.class.getName()));
    KnownNames known = new KnownNames(options);
    names =
        new ServiceNames(
            SystemFile.read(file), known, own::contains, kit.bus(), kit.clock(), said::add);
  }

  private void answer(String name, Class<?> service) {
    kit.publish(
        Channels.DISCOVERY,
        new DiscoveryResponse()
            .serviceName(name)
            .className(service.getName())
            .serviceType("HEALTH_MONITOR")
            .status(ServiceStatus.RUNNING));
  }

  @Test
  void learn_entryNamedByItsFile_keepsThatName() throws IOException {
    names(new LaunchOptions());

    answer("x", PathPlanner.class);
    answer("PathPlanner", PathPlanner.class);
    answer("Way", CessnaControl.class);

    assertThat(names.nameOf("PathPlanner")).contains("Way");
    assertThat(names.entryOf("Way")).contains("PathPlanner");
    assertThat(names.entryOf("x")).isEmpty();
  }

  @Test
  void learn_monitorNamedByAnOptionOfTheRun_keepsThatName() throws IOException {
    names(new LaunchOptions().override("HealthMonitor", "SERVICE NAME", "Doctor"));

    answer("HealthMonitor", HealthMonitor.class);

    assertThat(names.nameOf("HealthMonitor")).contains("Doctor");
    assertThat(names.monitors()).containsExactly("HealthMonitor");
  }

  @Test
  void learn_nameOfAnotherProcess_isIgnoredThoughItAnswersFirst() throws IOException {
    names(new LaunchOptions());

    answer("foreign", CessnaControl.class);
    answer("Control", CessnaControl.class);

    assertThat(names.nameOf("CessnaControl")).contains("Control");
    assertThat(names.entryOf("foreign")).isEmpty();
  }

  @Test
  void learn_nameThatOnlyTheServiceKnows_isTheFirstAnswered() throws IOException {
    names(new LaunchOptions());

    answer("SafetyManager", CessnaControl.class);
    answer("Control", CessnaControl.class);
    answer("x", CessnaControl.class);

    assertThat(names.nameOf("CessnaControl")).contains("Control");
    assertThat(names.entryOf("Control")).contains("CessnaControl");
    assertThat(names.entryOf("SafetyManager")).contains("SafetyManager");
    assertThat(names.entryOf("x")).isEmpty();
  }
}
