package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * The REMUS 100 of {@code config/vehicles/remus100.xml} against PythonVehicleSimulator's, which was
 * run with the same rudder, stern plane and propeller ({@code remus100_reference.py}).
 */
class Remus100Test {
  private static final double SHARE = 0.03;
  private static final double DEPTH_M = 200.0;
  private static final double FULL_DEG = 15.0;
  private static final double FULL_RPM = 1525.0;

  /** Rows of a run, values by column. */
  private record Run(String name, List<Map<String, Double>> rows) {
    @Override
    public String toString() {
      return name;
    }
  }

  static List<Run> runs() {
    Map<String, Run> runs = new LinkedHashMap<>();
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(
                Remus100Test.class.getResourceAsStream(
                    "/org/u2sa/sim/marine/remus100_reference.csv"),
                StandardCharsets.UTF_8))) {
      String[] columns = in.readLine().split(",");
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        String[] values = line.split(",");
        Map<String, Double> row = new LinkedHashMap<>();
        for (int i = 1; i < columns.length; i++) {
          row.put(columns[i], Double.valueOf(values[i]));
        }
        runs.computeIfAbsent(values[0], name -> new Run(name, new ArrayList<>())).rows().add(row);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return List.copyOf(runs.values());
  }

  private static SimulatedVehicle start(Map<String, Double> inputs) {
    World sea = World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, 0.0, 0.0));
    SimulatedVehicle remus =
        VehicleFile.load(Vehicles.REMUS_100).make(sea, Point.of(0.0, 0.0, -DEPTH_M), 0.0, 1);
    remus.command("RUDDER", inputs.get("rudder") / FULL_DEG);
    remus.command("STERN PLANE", inputs.get("sternplane") / FULL_DEG);
    remus.command("PROPELLER", inputs.get("rpm") / FULL_RPM);
    return remus;
  }

  @ParameterizedTest
  @MethodSource("runs")
  void step_sameInputs_movesAsTheReference(Run run) {
    SimulatedVehicle remus = start(run.rows().get(0));
    double pathM = 0.0;
    double turned = 0.0;
    double before = 0.0;
    for (Map<String, Double> row : run.rows()) {
      double seconds = row.get("t") - before;
      before = row.get("t");
      remus.step(seconds);
      VehicleTruth truth = remus.truth();
      Point enu = truth.velocity();
      Point body =
          truth.attitude().nedFromFrd().transposed().times(Point.of(enu.y(), enu.x(), -enu.z()));
      pathM += seconds * row.get("u");
      turned += seconds * Math.abs(row.get("r"));
      String at = run + " at " + before + " s: ";

      close(at + "u", body.x(), row.get("u"), 0.0);
      close(at + "v", body.y(), row.get("v"), 0.002);
      close(at + "w", body.z(), row.get("w"), 0.002);
      close(at + "p", truth.rates().x(), row.get("p"), 0.0005);
      close(at + "q", truth.rates().y(), row.get("q"), 0.0005);
      close(at + "r", truth.rates().z(), row.get("r"), 0.0002);
      close(at + "roll", truth.attitude().phi(), row.get("phi"), 0.001);
      close(at + "pitch", truth.attitude().theta(), row.get("theta"), 0.001);
      double psi = Math.IEEEremainder(truth.headingRad() - row.get("psi"), 2.0 * Math.PI);
      assertThat(psi).as(at + "heading").isCloseTo(0.0, within(SHARE * turned + 0.001));
      close(at + "depth", -truth.position().z() - DEPTH_M, row.get("down"), 0.05);
      assertThat(
              Math.hypot(
                  truth.position().y() - row.get("north"), truth.position().x() - row.get("east")))
          .as(at + "place")
          .isLessThan(SHARE * pathM);
    }
  }

  private static void close(String what, double actual, double expected, double floor) {
    assertThat(actual).as(what).isCloseTo(expected, within(SHARE * Math.abs(expected) + floor));
  }
}
