package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

class StatedPlacementTest {
  private static final Geodetic START = new Geodetic(10.0, 54.0, 0.0);

  private static List<String> differences(Map<String, ?> variables, Map<String, Point> mounted) {
    return new StatedPlacement(XmlConfiguration.inMemory("Estimator", variables))
        .differences(mounted, START);
  }

  @Test
  void differences_antennaThatLeverArmsDoNotName_isNamedWithItsPlace() {
    assertThat(differences(Map.of(), Map.of("GpsSensor", Point.of(0.3, 0.2, -0.5))))
        .singleElement()
        .asString()
        .contains("LEVER ARMS has GpsSensor at 0.00 0.00 0.00")
        .contains("the vehicle has it at 0.30 -0.20 -0.50 (forward left down, m)");
  }

  @Test
  void differences_sensorsWhereTheyAre_areNone() {
    Map<String, Point> mounted =
        Map.of(
            "GpsSensor", Point.of(0.3, 0.2, -0.5),
            "ImuSensor", Point.of(0.0, 0.0, 0.4),
            "WaterSpeedSensor", Point.of(0.0, 0.05, 0.0));
    assertThat(
            differences(
                Map.of(
                    "LEVER ARMS",
                    "GpsSensor = 0.3 -0.2 -0.5; ImuSensor inertial = 0 0 0.4",
                    "START X",
                    0.0),
                mounted))
        .isEmpty();
  }

  @Test
  void differences_surveyedStartElsewhere_namesBothPlaces() {
    assertThat(
            differences(Map.of("START X", -117.25, "START Y", 32.7, "START SIGMA", 0.1), Map.of()))
        .singleElement()
        .asString()
        .contains("START X, START Y are -117.250000, 32.700000 deg")
        .contains(" 9149.")
        .contains(" at 10.000000, 54.000000 deg");
    assertThat(
            differences(Map.of("START X", 10.0, "START Y", 54.00001, "START SIGMA", 0.1), Map.of()))
        .isEmpty();
  }
}
