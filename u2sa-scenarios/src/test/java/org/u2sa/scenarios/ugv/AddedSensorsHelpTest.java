package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * User story 9 by configuration alone: lines added to the ground vehicle's system file, of sensors
 * with a telephone's receiver's errors, make the estimate better, measured against truth.
 */
@Tag("long")
class AddedSensorsHelpTest {
  private static final String ESTIMATOR = "  <service class=\"org.u2sa.estimation.";
  private static final int SEEDS = 3;
  private static final double RUN_S = 90.0;
  private static final double SETTLED_S = 10.0;

  @TempDir private Path directory;

  /** Sum of squares of an error. */
  private static final class Rms {
    private double sum;
    private int count;

    void add(double error) {
      sum += error * error;
      count++;
    }

    double value() {
      return Math.sqrt(sum / count);
    }
  }

  /** The errors of a set of sensors, over the seeds. */
  private record Errors(Rms position, Rms heading) {}

  /** "ImuSensor=left" is an IMU named left. */
  private Path system(List<String> sensors) throws IOException {
    Path config = UgvDrive.config();
    StringBuilder lines = new StringBuilder();
    for (String each : sensors) {
      String[] parts = each.split("=");
      Path file = directory.resolve(parts[1] + ".xml");
      Files.writeString(
          file,
          "<configuration><variable name=\"SERVICE NAME\" type=\"string\" value=\""
              + parts[1]
              + "\"/></configuration>",
          UTF_8);
      lines.append("  <service class=\"org.u2sa.device.").append(parts[0]);
      lines.append("\" configuration=\"").append(file).append("\"/>\n");
    }
    String base =
        Files.readString(config.resolve("system-board.xml"), UTF_8)
            .replace("configuration=\"", "configuration=\"" + config + "/");
    return Files.writeString(
        directory.resolve("system.xml"), base.replace(ESTIMATOR, lines + ESTIMATOR), UTF_8);
  }

  private Errors drive(List<String> sensors) throws Exception {
    Errors errors = new Errors(new Rms(), new Rms());
    for (long seed = 1; seed <= SEEDS; seed++) {
      UgvDrive.Scene scene = new UgvDrive.Scene(seed, GpsGrade.PHONE, Hazards.none(), List.of());
      try (UgvDrive drive =
          new UgvDrive(
              directory.resolve("logs"),
              system(sensors),
              scene,
              true,
              options ->
                  options.override(
                      "FusingStateEstimator",
                      "POSITION CORRELATION",
                      GpsGrade.PHONE.correlationS()))) {
        drive.operator.onState(state -> look(drive, state, errors));
        drive.drive(RUN_S);
      }
    }
    return errors;
  }

  private static void look(UgvDrive drive, StateInformation state, Errors errors) {
    if (drive.nowS() < SETTLED_S || state.x().isEmpty() || state.psi().isEmpty()) {
      return;
    }
    VehicleTruth truth = drive.vehicle.truth();
    Geodetic there =
        drive.vehicle.world().plane().at(truth.position().x(), truth.position().y(), 0);
    Geodetic said = new Geodetic(state.x().getAsDouble(), state.y().getAsDouble(), 0.0);
    Point apart = there.enuOf(said);
    errors.position().add(Math.hypot(apart.x(), apart.y()));
    errors
        .heading()
        .add(Math.IEEEremainder(state.psi().getAsDouble() - truth.headingRad(), 2.0 * Math.PI));
  }

  @Test
  void run_sensorsAdded_estimateIsBetter() throws Exception {
    TreeMap<String, Errors> all = new TreeMap<>();
    for (List<String> sensors :
        List.of(
            List.<String>of(),
            List.of("GpsSensor=roof"),
            List.of("ImuSensor=left"),
            List.of("CompassSensor=mast"),
            List.of("WheelEncoderSensor=wheels"))) {
      Errors errors = drive(sensors);
      all.put(sensors.toString(), errors);
      report(sensors, errors);
    }
    Errors none = all.get("[]");
    assertThat(all.get("[GpsSensor=roof]").position().value())
        .isLessThan(0.9 * none.position().value());
    for (String each : List.of("[ImuSensor=left]", "[CompassSensor=mast]")) {
      assertThat(all.get(each).heading().value()).as(each).isLessThan(none.heading().value());
    }
    for (Errors each : all.values()) {
      assertThat(each.position().value()).isLessThan(1.05 * none.position().value());
    }
  }

  /** A row of the table in docs/state-estimation.md, into {@code target/} of the module. */
  private static void report(List<String> sensors, Errors errors) throws IOException {
    Path folder = Files.createDirectories(Path.of("target"));
    Files.writeString(
        folder.resolve("ugv-sensors-added.txt"),
        String.format(
            Locale.ROOT,
            "| %s | %.2f m | %.2f° |%n",
            sensors,
            errors.position().value(),
            Math.toDegrees(errors.heading().value())),
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }
}
