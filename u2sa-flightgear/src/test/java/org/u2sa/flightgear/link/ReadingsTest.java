package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;

final class ReadingsTest {
  @Test
  void of_line_turnsFlightGearsAxesIntoOurs() {
    Map<OutField, Double> values =
        Map.of(
            OutField.SPEED_DOWN, 2.0,
            OutField.AIR_RIGHT, 3.0,
            OutField.AIR_DOWN, 4.0,
            OutField.HEADING, 2.0 * Math.PI,
            OutField.HEIGHT, OutLine.STANDING_M);
    AircraftReading reading = Readings.of(OutLine.of(values), 1, 0);
    assertThat(Math.round(reading.upMps() * 1e6)).isEqualTo(-2_000_000);
    assertThat(Math.round(reading.airLeftMps() * 1e6)).isEqualTo(-3_000_000);
    assertThat(Math.round(reading.airDownMps() * 1e6)).isEqualTo(4_000_000);
    assertThat(reading.headingRad()).isLessThan(1e-9);
    assertThat(reading.heightAboveGroundM()).isZero();
  }

  @Test
  void line_ofAReading_isReadAsTheSameReading() {
    AircraftReading flying =
        new AircraftReading(
            true, 7, 0, -157.9, 21.3, 500.0, 495.0, 0.1, 0.2, 3.0, 0.01, 0.02, 0.03, 40.0, 5.0, 2.0,
            42.0, -1.0, 3.0, 41.0, 2_300.0, false, false, false);
    AircraftReading read = Readings.of(Readings.line(flying, 9.0, false, 17), 7, 0);
    assertThat(read)
        .usingRecursiveComparison()
        .withEqualsForType((a, b) -> Math.abs(a - b) < 1e-9, Double.class)
        .isEqualTo(flying);
  }

  @Test
  void lost_reading_changesOnlyWhetherItIsConnected() {
    AircraftReading flying = Readings.of(OutLine.of(Map.of(OutField.PITCH, 0.1)), 3, 5);
    assertThat(Readings.lost(flying))
        .usingRecursiveComparison()
        .ignoringFields("connected")
        .isEqualTo(flying);
    assertThat(Readings.lost(flying).connected()).isFalse();
  }
}
