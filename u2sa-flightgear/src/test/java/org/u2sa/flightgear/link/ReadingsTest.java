package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.flightgear.protocol.MalformedLineException;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateField;
import org.u2sa.messages.frame.ReferenceFrame;

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
    assertThat(Math.round(reading.state().zDot().orElse(0.0) * 1e6)).isEqualTo(-2_000_000);
    assertThat(Math.round(reading.state().fluidyDot().orElse(0.0) * 1e6)).isEqualTo(-3_000_000);
    assertThat(Math.round(reading.state().fluidzDot().orElse(0.0) * 1e6)).isEqualTo(4_000_000);
    assertThat(reading.state().psi().orElse(0.0)).isLessThan(1e-9);
    assertThat(reading.state().heightAboveGround().orElse(0.0)).isZero();
  }

  @Test
  void line_ofAReading_isReadAsTheSameReading() {
    AircraftState flying = new AircraftState();
    flying
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(-157.9)
        .y(21.3)
        .z(500.0)
        .xDot(5.0)
        .yDot(40.0)
        .zDot(2.0)
        .phi(0.1)
        .theta(0.2)
        .psi(3.0)
        .phiDot(0.01)
        .thetaDot(0.02)
        .psiDot(0.03)
        .fluidxDot(42.0)
        .fluidyDot(-1.0)
        .fluidzDot(3.0);
    flying.heightAboveGround(495.0).calibratedAirspeed(41.0).engineRpm(2_300.0);
    AircraftReading read = Readings.of(Readings.line(flying, 9.0, false, 17), 7, 0);
    for (StateField field : StateField.values()) {
      OptionalDouble expected = flying.number(field);
      assertThat(read.state().number(field).isPresent()).isEqualTo(expected.isPresent());
      assertThat(read.state().number(field).orElse(0.0))
          .as(field.fieldName())
          .isCloseTo(expected.orElse(0.0), within(1e-9));
    }
    assertThat(read.state().heightAboveGround().orElseThrow()).isCloseTo(495.0, within(1e-9));
    assertThat(read.state().calibratedAirspeed().orElseThrow()).isCloseTo(41.0, within(1e-9));
    assertThat(read.state().engineRpm().orElseThrow()).isCloseTo(2_300.0, within(1e-9));
    assertThat(read.state().weightOnWheels()).isFalse();
    assertThat(read.state().engineStarting()).isFalse();
    assertThat(read.state().crashed()).isFalse();
  }

  @Test
  void lost_reading_changesOnlyWhetherItIsConnected() {
    AircraftReading flying = Readings.of(OutLine.of(Map.of(OutField.PITCH, 0.1)), 3, 5);
    assertThat(flying.lost())
        .usingRecursiveComparison()
        .ignoringFields("connected")
        .isEqualTo(flying);
    assertThat(flying.lost().connected()).isFalse();
  }

  @Test
  void of_lineThatIsTaken_canBePublishedWhateverItsValues() {
    double[] numbers = {
      -36_000, -3_600, -2_000, -1_000, -180, -100, -90, -1, 0, 1, 90, 360, 1_000, 3_600, 60_000
    };
    int taken = 0;
    for (OutField field : OutField.values()) {
      for (double number : numbers) {
        Optional<OutLine> line = parsed(field, number);
        if (line.isPresent()) {
          taken++;
          AircraftReading reading = Readings.of(line.get(), 1, 0);
          assertThat(reading.state().calibratedAirspeed().orElseThrow()).isNotNegative();
          assertThat(reading.state().engineRpm().orElseThrow()).isNotNegative();
        }
      }
    }
    assertThat(taken).isGreaterThan(150);
  }

  /** A line of zeros but for one field; empty if it is refused. */
  private static Optional<OutLine> parsed(OutField changed, double number) {
    StringBuilder text = new StringBuilder();
    for (OutField each : OutField.values()) {
      double value = each == changed ? number : each == OutField.ELAPSED ? 1.0 : 0.0;
      text.append(text.length() == 0 ? "" : ",").append(value);
    }
    try {
      return Optional.of(OutLine.parse(text.toString()));
    } catch (MalformedLineException e) {
      return Optional.empty();
    }
  }
}
