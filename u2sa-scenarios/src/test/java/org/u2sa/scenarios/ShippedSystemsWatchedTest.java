package org.u2sa.scenarios;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.testkit.Repository;

/** Each service of each shipped system is watched by its Health Monitor, or not for a reason. */
class ShippedSystemsWatchedTest {
  private static final String FUSED =
      "one of several that the State Estimator fuses: it goes on with the others and says how uncertain it is";
  private static final Map<String, String> NOT_WATCHED =
      new TreeMap<>(
          Map.of(
              "HealthMonitor", "its process or the supervisor watches it",
              "GpsSensor", FUSED,
              "CompassSensor", FUSED,
              "ImuSensor", FUSED,
              "BarometerSensor", FUSED,
              "AirspeedSensor", FUSED,
              "WheelEncoderSensor", FUSED));

  static List<Path> systems() throws IOException {
    List<Path> systems = new ArrayList<>();
    for (String folder : List.of("cessna", "igvc", "ugv")) {
      try (Stream<Path> files = Files.list(Repository.root().resolve("config").resolve(folder))) {
        files
            .filter(file -> file.getFileName().toString().matches("system.*\\.xml"))
            .sorted()
            .forEach(systems::add);
      }
    }
    return systems;
  }

  private static SystemFile.Entry entry(SystemFile system, String name) {
    return system.services().stream()
        .filter(service -> service.simpleName().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static XmlConfiguration configuration(SystemFile system, String service) {
    return XmlConfiguration.load(entry(system, service).configuration().orElseThrow());
  }

  private static List<String> names(XmlConfiguration configuration, String variable) {
    return Arrays.stream(((String) configuration.getVariable(variable)).split(","))
        .map(String::trim)
        .toList();
  }

  @ParameterizedTest
  @MethodSource("systems")
  void system_eachService_isWatchedOrNotForAReason(Path file) {
    SystemFile system = SystemFile.read(file);
    List<String> watched = names(configuration(system, "HealthMonitor"), "WATCHED");

    assertThat(system.services())
        .extracting(SystemFile.Entry::simpleName)
        .filteredOn(name -> !NOT_WATCHED.containsKey(name))
        .allSatisfy(name -> assertThat(watched).anyMatch(name::endsWith));
    assertThat(watched) // what is not there would be LOST
        .allSatisfy(
            name ->
                assertThat(system.services())
                    .anyMatch(service -> service.simpleName().endsWith(name)));
  }

  @ParameterizedTest
  @MethodSource("systems")
  void system_withALaser_standsWithoutIt(Path file) {
    SystemFile system = SystemFile.read(file);
    if (system.services().stream().anyMatch(each -> each.simpleName().equals("LidarSensor"))) {
      XmlConfiguration monitor = configuration(system, "HealthMonitor");
      assertThat(monitor.getVariable("LidarSensor POLICY")).isEqualTo("FAILSAFE");
      assertThat((double) monitor.getVariable("LidarSensor DATA TIMEOUT")).isLessThanOrEqualTo(1.0);
      assertThat(names(configuration(system, "WorldModeler"), "EXPECTED SENSORS"))
          .contains("LidarSensor");
    }
  }

  @Test
  void exemptions_allAreNeeded() throws IOException {
    List<String> all = new ArrayList<>();
    for (Path file : systems()) {
      SystemFile.read(file).services().forEach(service -> all.add(service.simpleName()));
    }
    assertThat(all).containsAll(NOT_WATCHED.keySet());
  }
}
