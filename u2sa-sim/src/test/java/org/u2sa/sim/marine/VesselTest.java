package org.u2sa.sim.marine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

class VesselTest {
  private static final World POOL =
      World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, 0.0, 0.0));

  private static World current(double east, double north) {
    return World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, east, north));
  }

  /** Against the functions of PythonVehicleSimulator and SciPy: fossen_reference.py. */
  @ParameterizedTest
  @CsvSource({
    "surge, 0.25, 0.25, 0.25, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0",
    "all, 0.3, -0.2, 0.25, 0.15, 0.3, -0.2, 0.0, 0.0, 0.7",
    "current, 0.15, 0.25, 0.2, 0.1, 0.25, 0.2, 0.3, -0.2, -1.2",
    "yaw, -0.3, 0.3, 0.3, -0.3, -0.2, -0.2, 0.1, 0.4, 2.0"
  })
  void step_stepsOfThrust_areThoseOfTheReference(
      String run,
      double first,
      double second,
      double third,
      double fourth,
      double fifth,
      double sixth,
      double north,
      double east,
      double heading)
      throws IOException {
    Vessel vessel = BlueRov2.at(current(east, north), Point.of(0.0, 0.0, -50.0), heading);
    double[] commands = {first, second, third, fourth, fifth, sixth};
    for (int i = 0; i < commands.length; i++) {
      vessel.command("THRUSTER " + (i + 1), commands[i]);
    }

    for (double[] row : reference(run)) {
      if (row[0] > 0.0) {
        vessel.step(0.5);
      }
      VehicleTruth truth = vessel.truth();
      assertThat(truth.timeS()).isCloseTo(row[0], within(1e-9));
      assertThat(truth.position().y()).isCloseTo(row[1], within(1e-4));
      assertThat(truth.position().x()).isCloseTo(row[2], within(1e-4));
      assertThat(truth.position().z()).isCloseTo(-row[3], within(1e-4));
      assertThat(turn(truth.attitude().phi(), row[4])).isCloseTo(0.0, within(1e-4));
      assertThat(turn(truth.attitude().theta(), row[5])).isCloseTo(0.0, within(1e-4));
      assertThat(turn(truth.attitude().psi(), row[6])).isCloseTo(0.0, within(1e-4));
      assertThat(vessel.throughWater().x()).isCloseTo(row[7], within(1e-4));
      assertThat(vessel.throughWater().y()).isCloseTo(row[8], within(1e-4));
      assertThat(vessel.throughWater().z()).isCloseTo(row[9], within(1e-4));
      assertThat(truth.rates().x()).isCloseTo(row[10], within(1e-4));
      assertThat(truth.rates().y()).isCloseTo(row[11], within(1e-4));
      assertThat(truth.rates().z()).isCloseTo(row[12], within(1e-4));
    }
  }

  private static double turn(double from, double to) {
    return Math.IEEEremainder(to - from, 2.0 * Math.PI);
  }

  private static List<double[]> reference(String run) throws IOException {
    List<double[]> rows = new ArrayList<>();
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(
                VesselTest.class.getResourceAsStream("blue_rov2_reference.csv"),
                StandardCharsets.UTF_8))) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        String[] cells = line.split(",");
        if (cells[0].equals(run)) {
          double[] row = new double[cells.length - 1];
          for (int i = 0; i < row.length; i++) {
            row[i] = Double.parseDouble(cells[i + 1]);
          }
          rows.add(row);
        }
      }
    }
    assertThat(rows).hasSize(31);
    return rows;
  }

  @Test
  void step_slowAhead_reachesTheSpeedWhereDragEqualsThrust() {
    Vessel vessel = BlueRov2.at(POOL, Point.of(0.0, 0.0, -10.0), 0.0);
    for (int i = 1; i <= 4; i++) {
      vessel.command("THRUSTER " + i, 0.2);
    }

    vessel.step(20.0);

    double thrust = 4 * BlueRov2.FORWARD_N * Math.pow(0.16 / 0.96, 2) * Math.sqrt(0.5);
    double speed = (-4.03 + Math.sqrt(4.03 * 4.03 + 4 * 18.18 * thrust)) / (2 * 18.18);
    assertThat(vessel.throughWater().x()).isCloseTo(speed, within(0.03)); // pitch takes a little
  }

  @Test
  void step_nothingCommanded_risesAndFloatsAtTheSurface() {
    Vessel vessel = BlueRov2.at(POOL, Point.of(0.0, 0.0, -2.0), 0.0);

    vessel.step(60.0);
    vessel.step(60.0);

    assertThat(vessel.truth().position().z()).isBetween(-0.13, 0.0);
    assertThat(vessel.truth().velocity().z()).isCloseTo(0.0, within(0.02));
  }

  @Test
  void truth_specificForceAtRest_isGravityUpwards() {
    Vessel vessel = BlueRov2.at(POOL, Point.of(0.0, 0.0, -2.0), 1.0);

    assertThat(vessel.truth().specificForce().z()).isCloseTo(-9.807 - 0.08, within(0.06));
  }

  @Test
  void step_manySmallSteps_equalOneLarge() {
    Vessel one = BlueRov2.at(POOL, Point.of(0.0, 0.0, -2.0), 1.0);
    Vessel other = BlueRov2.at(POOL, Point.of(0.0, 0.0, -2.0), 1.0);
    one.command("THRUSTER 1", 0.7);
    other.command("THRUSTER 1", 0.7);

    one.step(1.0);
    for (int i = 0; i < 1000; i++) {
      other.step(0.001);
    }

    assertThat(other.truth()).isEqualTo(one.truth());
  }

  /** A bed that rises towards the east, at height 0 below the start; the hull is 0.25 m high. */
  @Test
  void isAground_hullInTheBed_isOneContactWithTheGround() {
    World bay = POOL.with(new Terrain.Plane(0.1, 0.0)).with(new Water(3.0, 0.0, 0.0));
    Vessel above = BlueRov2.at(bay, Point.of(0.0, 0.0, 0.3), 0.0);
    Vessel below = BlueRov2.at(bay, Point.of(0.0, 0.0, -0.3), 0.0);

    assertThat(above.isAground()).isFalse();
    assertThat(below.isAground()).isTrue();
    assertThat(BlueRov2.at(POOL, Point.of(0.0, 0.0, -0.3), 0.0).isAground()).as("no bed").isFalse();
    VehicleRun run = new VehicleRun(below);
    run.at(0L);
    run.at(100_000L);
    run.at(200_000L);
    assertThat(run.contacts()).hasSize(1);
    assertThat(run.contacts().get(0).object().uid()).isEqualTo("ground");
  }

  @Test
  void command_unknownThrusterOrTooMuch_isRefused() {
    Vessel vessel = BlueRov2.at(POOL, Point.ORIGIN, 0.0);

    assertThatThrownBy(() -> vessel.command("THRUSTER 7", 0.0)).hasMessageContaining("THRUSTER 7");
    assertThatThrownBy(() -> vessel.command("THRUSTER 1", 1.1)).hasMessageContaining("1.1");
    assertThatThrownBy(() -> BlueRov2.at(World.at(new Geodetic(9.0, 54.0, 0.0)), Point.ORIGIN, 0.0))
        .hasMessageContaining("water");
  }
}
