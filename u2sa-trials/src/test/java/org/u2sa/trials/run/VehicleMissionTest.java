package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Mission;
import org.u2sa.mission.MissionManager;

/** The thesis's own snippets, which give no threshold, on every vehicle that is shipped. */
class VehicleMissionTest {
  private static final Path ROOT = Path.of("..");
  private static final String SNIPPETS =
      """
      <mission>
        <home><x>-121.134</x><y>37.466</y><psi>0</psi></home>
        <waypoint>
          <name>1</name>
          <next>2</next>
          <reference>Global</reference>
          <x>10</x>
          <y>15</y>
        </waypoint>
        <waypoint>
          <name>2</name>
          <y>37.466189</y>
          <x>-121.134548</x>
          <z>3000</z>
        </waypoint>
      </mission>
      """;

  @TempDir private Path directory;

  /** Every system file of the repository, each in a folder as the vehicle has it. */
  static List<Path> systems() throws IOException {
    try (Stream<Path> files = Files.walk(ROOT.resolve("config"))) {
      return files
          .filter(file -> file.getFileName().toString().matches("system.*\\.xml"))
          .sorted()
          .toList();
    }
  }

  private Path snippets() throws IOException {
    return Files.writeString(directory.resolve("thesis.xml"), SNIPPETS);
  }

  private static double configuredM(Path folder) {
    return XmlConfiguration.load(folder.resolve("MissionManager.xml"))
        .settings(MissionManager.Defaults.class)
        .get()
        .defaultThreshold();
  }

  private static void requireThresholds(Mission mission, double thresholdM) {
    assertThat(mission.goals())
        .hasSize(2)
        .allSatisfy(
            goal -> assertThat(((Waypoint) goal).horizontalThreshold()).isEqualTo(thresholdM));
  }

  @ParameterizedTest
  @MethodSource("systems")
  void load_bareSnippets_takesTheThresholdOfTheVehicle(Path system) throws IOException {
    requireThresholds(
        VehicleMission.load(SystemFile.read(system), new LaunchOptions(), snippets()),
        configuredM(system.getParent()));
  }

  @Test
  void load_bareSnippetsOnThePhone_takesTheThresholdOfTheGroundVehicle() throws IOException {
    for (Path folder :
        List.of(
            ROOT.resolve("config/ugv"),
            ROOT.resolve("u2sa-android/src/main/assets/config/ugv"))) { // laid over it in the app
      try (Stream<Path> files = Files.list(folder)) {
        for (Path file : files.toList()) {
          Files.copy(file, directory.resolve(file.getFileName()));
        }
      }
    }

    requireThresholds(
        VehicleMission.load(
            SystemFile.read(directory.resolve("system-phone.xml")),
            new LaunchOptions(),
            snippets()),
        0.5);
  }

  @Test
  void load_vehiclesOfTheRepository_eachHasAThresholdOfItsOwn() {
    assertThat(configuredM(ROOT.resolve("config/ugv"))).isEqualTo(0.5);
    assertThat(configuredM(ROOT.resolve("config/cessna"))).isEqualTo(100.0);
  }

  @Test
  void load_thresholdSetForTheRun_counts() throws IOException {
    requireThresholds(
        VehicleMission.load(
            SystemFile.read(ROOT.resolve("config/ugv/system.xml")),
            new LaunchOptions().override("MissionManager", "DEFAULT THRESHOLD", 2),
            snippets()),
        2.0);
  }

  @Test
  void load_systemWithoutMissionManager_isRefused() throws IOException {
    SystemFile none = SystemFile.read(ROOT.resolve("config/ugv/system.xml")).only("PathPlanner");
    Path mission = snippets();

    assertThatThrownBy(() -> VehicleMission.load(none, new LaunchOptions(), mission))
        .isInstanceOf(BadInputException.class)
        .hasMessageContainingAll("lists no service org.u2sa.mission.MissionManager");
  }

  @Test
  void load_withoutAVehicle_knowsNoThreshold() throws IOException {
    Waypoint bare = (Waypoint) Mission.load(snippets()).goals().get(0);

    assertThatThrownBy(bare::horizontalThreshold)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("horizontalThreshold");
  }

  @Test
  void loiterRadiusM_ofAVehicleThatCirclesOrStays_isThePlanners() {
    LaunchOptions none = new LaunchOptions();
    SystemFile cessna = SystemFile.read(ROOT.resolve("config/cessna/system.xml"));
    LaunchOptions other = new LaunchOptions().override("PathPlanner", "LOITER RADIUS", 300.0);

    assertThat(VehicleMission.loiterRadiusM(cessna, none)).isEqualTo(800.0);
    assertThat(VehicleMission.loiterRadiusM(cessna, other)).isEqualTo(300.0);
    SystemFile rover = SystemFile.read(ROOT.resolve("config/ugv/system.xml"));
    assertThat(VehicleMission.loiterRadiusM(rover, none)).isZero();
  }
}
