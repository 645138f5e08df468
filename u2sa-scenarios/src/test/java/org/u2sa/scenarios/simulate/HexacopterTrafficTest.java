package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/**
 * A hexacopter in a corridor too narrow to let an aircraft pass that comes the other way and is
 * faster: only another altitude keeps the 20 m of its sphere, below if the fence's ceiling is low.
 */
class HexacopterTrafficTest {
  private static final Pattern LEAST = Pattern.compile("\"leastDistanceM\" : ([0-9.]+)");
  private static final double BODY_M = 2.0;

  @TempDir private Path folder;

  private String file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text).toString();
  }

  @ParameterizedTest
  @CsvSource({"2, 200, 20, 60", "2, 95, 20, 60"})
  void simulate_trafficInANarrowCorridor_isPassedAboveOrBelowIfItMayClimbAndTheFenceIsKept(
      double climbMps, double ceilingM, double leastM, double mostM) throws IOException {
    Path config = Repository.root().resolve("config/suas/hexacopter");
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            config.resolve("system-world.xml").toString(),
            "--vehicle",
            config.resolve("vehicle.xml").toString(),
            "--mission",
            file(
                "mission.xml",
                """
                <mission>
                  <home><x>-76.55578</x><y>38.31633</y><z>43.3</z><psi>90</psi></home>
                  <takeOff><z>83.3</z></takeOff>
                  <waypoint><x>-76.55418</x><y>38.31633</y><z>83.3</z></waypoint>
                </mission>
                """),
            "--world",
            file(
                "world.xml",
                """
                <world>
                  <mover>
                    <sphere><uid>N1</uid><referenceFrame>Global</referenceFrame>
                      <x>-76.54978</x><y>38.31633</y><z>83.3</z><radius>2</radius></sphere>
                    <waypoint><x>-76.58</x><y>38.31633</y><z>83.3</z><speed>15</speed></waypoint>
                    <transponder>true</transponder>
                  </mover>
                </world>
                """),
            "--set",
            "WorldModeler:WORLD="
                + file(
                    "corridor.xml",
                    """
                    <world>
                      <polygon><uid>lane</uid><objectType>corridor</objectType>
                        <referenceFrame>Global</referenceFrame>
                        <points>-76.557 38.31622; -76.550 38.31622;
                          -76.550 38.31644; -76.557 38.31644</points>
                        <z>98.3</z><height>100</height></polygon>
                    </world>
                    """),
            "--set",
            "PathPlanner:EVASION CLIMB=" + climbMps,
            "--set",
            "SafetyManager:FENCE="
                + file(
                    "fence.xml",
                    "<fence><ceiling>"
                        + ceilingM
                        + "</ceiling><keepIn><centre><x>-76.555</x><y>38.316</y></centre>"
                        + "<radius>2000</radius></keepIn></fence>"),
            "--limit",
            "40",
            "--port",
            "0",
            "--out",
            folder.resolve("out").toString());
    Matcher least = LEAST.matcher(Files.readString(folder.resolve("out/summary.json")));

    assertThat(least.find()).as(run.out() + run.err()).isTrue();
    assertThat(Double.parseDouble(least.group(1)) + BODY_M).isBetween(leastM, mostM);
    assertThat(Files.readString(folder.resolve("out/logs/SafetyManager.log")))
        .doesNotContain("geofence");
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({"0, 200, 0, 18"})
  void simulate_trafficInANarrowCorridorAndMayNotClimb_isNotPassedAboveOrBelow(
      double climbMps, double ceilingM, double leastM, double mostM) throws IOException {
    simulate_trafficInANarrowCorridor_isPassedAboveOrBelowIfItMayClimbAndTheFenceIsKept(
        climbMps, ceilingM, leastM, mostM);
  }
}
