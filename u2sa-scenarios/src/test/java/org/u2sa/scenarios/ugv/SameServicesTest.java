package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.testkit.Repository;

/**
 * The ground vehicle runs the Cessna's State Estimator, Mission Manager and Path Planner (thesis
 * 4.6): of all services only the control and the one that interacts with the hardware differ,
 * beside sensors.
 */
class SameServicesTest {
  private static Set<String> classes(String file) {
    return SystemFile.read(Repository.root().resolve("config").resolve(file)).services().stream()
        .map(SystemFile.Entry::className)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static Set<String> withoutSensors(String file) {
    Set<String> classes = classes(file);
    classes.removeIf(name -> name.startsWith("org.u2sa.device."));
    return classes;
  }

  private static Set<String> without(Set<String> all, Set<String> others) {
    Set<String> rest = new TreeSet<>(all);
    rest.removeAll(others);
    return rest;
  }

  @ParameterizedTest
  @CsvSource({
    "system.xml, system-fused.xml, FusingStateEstimator",
    "system-ackermann.xml, system-fused.xml, FusingStateEstimator",
    "system-pass-through.xml, system.xml, PassThroughStateEstimator",
    "system-proportional.xml, system.xml, PassThroughStateEstimator"
  })
  void services_besideTheCessnas_onlyControlAndInteractionDiffer(
      String file, String cessnas, String estimator) {
    Set<String> cessna = withoutSensors("cessna/" + cessnas);
    Set<String> ugv = withoutSensors("ugv/" + file);

    assertThat(ugv)
        .containsAll(
            List.of(
                "org.u2sa.estimation." + estimator,
                "org.u2sa.mission.MissionManager",
                "org.u2sa.planning.PathPlanner",
                "org.u2sa.core.safety.SafetyManager",
                "org.u2sa.core.health.HealthMonitor"));
    assertThat(without(cessna, ugv))
        .containsExactlyInAnyOrder(
            "org.u2sa.flightgear.link.Simulator", "org.u2sa.control.fixedwing.CessnaControl");
    assertThat(without(ugv, cessna))
        .hasSize(2)
        .contains("org.u2sa.drivers.ioio.IoioService")
        .anyMatch(name -> name.startsWith("org.u2sa.control.ground."));
  }
}
