package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.launch.SystemFile;

/**
 * The ground vehicle runs the Cessna's State Estimator, Mission Manager and Path Planner (thesis
 * 4.6): of all services only the control and the one that interacts with the hardware differ.
 */
class SameServicesTest {
  private static Set<String> classes(String file) {
    return SystemFile.read(UgvCommandLine.repository().resolve("config").resolve(file))
        .services()
        .stream()
        .map(SystemFile.Entry::className)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static Set<String> without(Set<String> all, Set<String> others) {
    Set<String> rest = new TreeSet<>(all);
    rest.removeAll(others);
    return rest;
  }

  @ParameterizedTest
  @ValueSource(strings = {"system.xml", "system-proportional.xml", "system-ackermann.xml"})
  void services_besideTheCessnas_onlyControlAndInteractionDiffer(String file) {
    Set<String> cessna = classes("cessna/system.xml");
    Set<String> ugv = classes("ugv/" + file);

    assertThat(ugv)
        .containsAll(
            List.of(
                "org.u2sa.core.estimation.PassThroughStateEstimator",
                "org.u2sa.core.mission.MissionManager",
                "org.u2sa.core.planning.PathPlanner",
                "org.u2sa.core.safety.SafetyManager",
                "org.u2sa.core.health.HealthMonitor"));
    assertThat(without(cessna, ugv))
        .containsExactlyInAnyOrder(
            "org.u2sa.flightgear.link.Simulator", "org.u2sa.core.control.fixedwing.CessnaControl");
    assertThat(without(ugv, cessna))
        .hasSize(2)
        .contains("org.u2sa.drivers.ioio.IoioService")
        .anyMatch(name -> name.startsWith("org.u2sa.core.control.ground."));
  }
}
