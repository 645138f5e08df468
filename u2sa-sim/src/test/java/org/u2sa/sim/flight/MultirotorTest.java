package org.u2sa.sim.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

class MultirotorTest {
  private static final double HOVER_RADPS = Math.sqrt(0.5 * 9.80665 / (4 * 5.57e-6));

  private static List<double[]> reference(String run) throws IOException {
    String all =
        new String(
            MultirotorTest.class.getResourceAsStream("hummingbird_reference.csv").readAllBytes(),
            StandardCharsets.UTF_8);
    return all.lines()
        .map(line -> line.split(","))
        .filter(cells -> cells[0].equals(run))
        .map(cells -> Arrays.stream(cells).skip(1).mapToDouble(Double::parseDouble).toArray())
        .toList();
  }

  /** Against rotorpy 3.0.0: rotorpy_reference.py. The wind blows from the reverse of (4, −3). */
  @ParameterizedTest
  @CsvSource({
    "hover, 21, 469, 469, 469, 469, 0, 0",
    "climb, 21, 560, 560, 560, 560, 0, 0",
    "yaw, 21, 480, 458, 480, 458, 0, 0",
    "tilt, 11, 470, 468, 472, 471, 0, 0",
    "wind, 21, 480, 480, 480, 480, 5, 143.13010235415598"
  })
  void step_rotorSpeeds_isRotorpysFlight(
      String run,
      int rows,
      double first,
      double second,
      double third,
      double fourth,
      double windMps,
      double windFromDeg)
      throws IOException {
    World world = Hummingbird.FIELD.with(Wind.constant(Math.toRadians(windFromDeg), windMps));
    UnmannedAircraft aircraft = Hummingbird.quad(world, 100.0);
    Hummingbird.command(aircraft, first, second, third, fourth);

    List<double[]> reference = reference(run);

    assertThat(reference).hasSize(rows);
    for (double[] row : reference) {
      if (row[0] > 0.0) {
        aircraft.step(0.1);
      }
      VehicleTruth truth = aircraft.truth();
      double[] actual = {
        truth.timeS(),
        truth.position().y(),
        truth.position().x(),
        100.0 - truth.position().z(),
        truth.velocity().y(),
        truth.velocity().x(),
        -truth.velocity().z(),
        signed(truth.attitude().phi()),
        truth.attitude().theta(),
        signed(truth.attitude().psi()),
        truth.rates().x(),
        truth.rates().y(),
        truth.rates().z()
      };
      for (int i = 0; i < actual.length; i++) {
        assertThat(actual[i]).as("column %d at %.1f s", i, row[0]).isCloseTo(row[i], within(2e-4));
      }
    }
  }

  private static double signed(double rad) {
    return Math.IEEEremainder(rad, 2.0 * Math.PI);
  }

  @Test
  void step_rotorsAtTheirHoverSpeed_staysWhereItIs() {
    UnmannedAircraft aircraft = Hummingbird.quad(Hummingbird.FIELD, 50.0);
    Hummingbird.command(aircraft, HOVER_RADPS, HOVER_RADPS, HOVER_RADPS, HOVER_RADPS);

    aircraft.step(0.2);
    double sink = aircraft.truth().velocity().z();
    aircraft.step(1.0);

    assertThat(HOVER_RADPS).isCloseTo(469.0, within(1.0)); // rotorpy's hover
    assertThat(aircraft.truth().velocity().z()).isCloseTo(sink, within(0.05));
    assertThat(aircraft.truth().acceleration().distance()).isLessThan(0.05);
  }

  @Test
  void step_onTheGround_standsStillInWind() {
    World windy = Hummingbird.FIELD.with(Wind.constant(1.0, 8.0));
    UnmannedAircraft aircraft = Hummingbird.quad(windy, Hummingbird.STANDS_M);

    aircraft.step(5.0);
    Point before = aircraft.truth().position();
    aircraft.step(60.0);

    assertThat(aircraft.stands()).isTrue();
    assertThat(aircraft.truth().position().minus(before).distance()).isLessThan(0.001);
    assertThat(aircraft.truth().specificForce().z()).isCloseTo(-9.80665, within(0.01));
  }

  @Test
  void step_takenOffAndLetDownSlowly_standsAgain() {
    UnmannedAircraft aircraft = Hummingbird.quad(Hummingbird.FIELD, Hummingbird.STANDS_M);
    Hummingbird.command(aircraft, 500, 500, 500, 500);
    aircraft.step(2.0);
    assertThat(aircraft.stands()).isFalse();
    double height = aircraft.truth().position().z();

    for (int i = 0; i < 400 && !aircraft.stands(); i++) {
      double sink = -aircraft.truth().velocity().z();
      double speed = HOVER_RADPS + 60.0 * (sink - 0.5);
      Hummingbird.command(aircraft, speed, speed, speed, speed);
      aircraft.step(0.05);
    }
    Hummingbird.command(aircraft, 0, 0, 0, 0);
    aircraft.step(2.0);

    assertThat(height).isGreaterThan(1.0);
    assertThat(aircraft.isAground()).isFalse();
    assertThat(aircraft.truth().speedMps()).isLessThan(0.001);
    assertThat(aircraft.truth().position().z()).isCloseTo(Hummingbird.STANDS_M, within(0.02));
  }

  @Test
  void step_rotorsStopInTheAir_crashesAndLies() {
    UnmannedAircraft aircraft = Hummingbird.quad(Hummingbird.FIELD, 20.0);

    aircraft.step(10.0);

    assertThat(aircraft.isAground()).isTrue();
    assertThat(aircraft.truth().velocity().distance()).isZero();
    assertThat(aircraft.truth().position().z()).isBetween(-0.2, 0.2);
  }

  @Test
  void weaken_oneRotorOfSix_turnsItTowardsThatRotor() {
    UnmannedAircraft aircraft = Hummingbird.hexa(Hummingbird.FIELD, 50.0);
    double speed = HOVER_RADPS * Math.sqrt(4.0 / 6.0);
    Hummingbird.command(aircraft, speed, speed, speed, speed, speed, speed);
    aircraft.step(0.2);

    aircraft.weaken("ROTOR 1", 0.0); // ahead
    aircraft.step(0.1);

    assertThat(aircraft.truth().rates().y()).isLessThan(-1.0); // nose down
    assertThatThrownBy(() -> aircraft.weaken("ROTOR 7", 0.0))
        .hasMessageContaining("ROTOR 7")
        .hasMessageContaining("ROTOR 6");
    assertThatThrownBy(() -> aircraft.weaken("ROTOR 1", -0.1)).hasMessageContaining("-0.1");
  }

  @Test
  void step_manySmallSteps_equalOneLarge() {
    UnmannedAircraft one = Hummingbird.quad(Hummingbird.FIELD, 50.0);
    UnmannedAircraft other = Hummingbird.quad(Hummingbird.FIELD, 50.0);
    Hummingbird.command(one, 480, 470, 475, 470);
    Hummingbird.command(other, 480, 470, 475, 470);

    one.step(0.5);
    for (int i = 0; i < 1000; i++) {
      other.step(0.0005);
    }

    assertThat(other.truth()).isEqualTo(one.truth());
  }

  @Test
  void command_outsideItsRange_isRefusedByName() {
    UnmannedAircraft aircraft = Hummingbird.quad(Hummingbird.FIELD, 50.0);

    assertThatThrownBy(() -> aircraft.command("ROTOR 2", -0.1))
        .hasMessageContaining("ROTOR 2")
        .hasMessageContaining("-0.1");
    assertThatThrownBy(() -> aircraft.command("MOTOR", 0.1)).hasMessageContaining("ROTOR 1");
  }
}
