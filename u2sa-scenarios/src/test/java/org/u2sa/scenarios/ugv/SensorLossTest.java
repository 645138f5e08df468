package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Collections;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.sim.ground.Hazards;

/**
 * The ground vehicle with GPS, compass, IMU and encoders as four services: what is left of the
 * drive when some of them are killed, or are not there at all.
 */
@Timeout(300)
class SensorLossTest {
  private static final double KILLED_AT_S = 40.0; // on the second leg
  private static final double ENOUGH_S = 200.0;
  private static final int LOOP = 6;

  @TempDir private Path directory;

  private Path without(String... services) throws IOException {
    Path config = UgvDrive.config();
    String system = Files.readString(config.resolve("system-four-sensors.xml"), UTF_8);
    for (String each : services) {
      String line = "  <service class=\"org.u2sa.device." + each;
      int from = system.indexOf(line);
      assertThat(from).as(each).isPositive();
      system = system.substring(0, from) + system.substring(system.indexOf('\n', from) + 1);
    }
    system = system.replace("configuration=\"", "configuration=\"" + config + "/");
    return Files.writeString(directory.resolve("system.xml"), system, UTF_8);
  }

  private UgvDrive start(Path system) {
    return new UgvDrive(directory.resolve("logs"), system, 1, Hazards.none(), true);
  }

  private UgvDrive startAndKill(String services) throws Exception {
    UgvDrive drive = start(without());
    drive.driveUntil("drives a while", () -> drive.nowS() >= KILLED_AT_S, ENOUGH_S);
    for (String each : services.split(" ")) {
      drive.kill(each);
    }
    return drive;
  }

  /** Into {@code target/ugv-sensors-lost.txt} of the module. */
  private static void report(String what, String figures) throws IOException {
    Path folder = Files.createDirectories(Path.of("target"));
    Files.writeString(
        folder.resolve("ugv-sensors-lost.txt"),
        what + ": " + figures + "\n",
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }

  private void requireTheLoop(String what, UgvDrive drive, double farthestM) throws Exception {
    drive.driveUntil("the loop " + what, () -> drive.operator.goalsDone() == LOOP, ENOUGH_S);
    report(
        what,
        String.format(
            Locale.ROOT, "%.0f s, farthest %.2f m", drive.nowS(), Collections.max(drive.misses())));
    assertThat(Collections.max(drive.misses()))
        .as(what + " " + drive.misses())
        .isLessThan(farthestM);
    assertThat(drive.operator.action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(drive.contacts()).isZero();
  }

  private void requireKilledLoop(String services, double farthestM) throws Exception {
    try (UgvDrive drive = startAndKill(services)) {
      requireTheLoop("killed " + services, drive, farthestM);
      for (String each : services.split(" ")) {
        assertThat(drive.operator.remarks("StateEstimator"))
            .anyMatch(remark -> remark.startsWith(each + ": silent"));
      }
    }
  }

  /** 0.5 m is a waypoint's threshold: what is more is the estimate's error. */
  @ParameterizedTest
  @CsvSource({"GpsSensor, 0.8", "WheelEncoderSensor, 0.5"})
  void killed_whileDriving_drivesTheLoopAndSaysWhichIsSilent(String service, double farthestM)
      throws Exception {
    requireKilledLoop(service, farthestM);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "CompassSensor, 0.5",
    "ImuSensor, 0.5",
    "ImuSensor WheelEncoderSensor, 0.5",
    "CompassSensor WheelEncoderSensor, 0.5",
    "CompassSensor ImuSensor, 0.5",
    "GpsSensor ImuSensor, 1.2",
    "GpsSensor CompassSensor, 1.2",
    "GpsSensor CompassSensor ImuSensor, 3.5"
  })
  void killed_othersOrSeveralWhileDriving_drivesTheLoopAndSaysWhichAreSilent(
      String services, double farthestM) throws Exception {
    requireKilledLoop(services, farthestM);
  }

  /** Without GPS and wheels nothing says how fast the vehicle is for longer than seconds. */
  @ParameterizedTest
  @CsvSource({"GpsSensor WheelEncoderSensor", "GpsSensor WheelEncoderSensor ImuSensor"})
  void killed_gpsAndEncoders_stopsAndSaysWhy(String services) throws Exception {
    try (UgvDrive drive = startAndKill(services)) {
      UgvDrive.Stop stop = drive.stop(20.0);

      report(
          "killed " + services,
          String.format(Locale.ROOT, "stands after %.2f s, %.2f m", stop.standsS(), stop.wayM()));
      assertThat(stop.standsS()).isLessThan(7.0); // 5 s of dead reckoning, and braking
      assertThat(stop.wayM()).isLessThan(10.0); // it speeds up where nothing measures its speed
      drive.requireStanding(30.0);
      assertThat(drive.operator.action()).isEqualTo(FailsafeAction.HOLD);
      assertThat(drive.operator.causes()).anyMatch(cause -> cause.startsWith("position"));
      assertThat(drive.operator.remarks("StateEstimator"))
          .anyMatch(remark -> remark.startsWith("GpsSensor: silent"))
          .anyMatch(remark -> remark.startsWith("WheelEncoderSensor: silent"));
    }
  }

  @ParameterizedTest
  @CsvSource({"CompassSensor, 0.5", "ImuSensor, 0.5"})
  void absent_fromTheSystemFile_drivesTheLoop(String service, double farthestM) throws Exception {
    try (UgvDrive drive = start(without(service))) {
      requireTheLoop("without " + service, drive, farthestM);
    }
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "WheelEncoderSensor, 0.5",
    "ImuSensor WheelEncoderSensor, 0.5",
    "CompassSensor WheelEncoderSensor, 0.5"
  })
  void absent_oneOrTwo_drivesTheLoop(String services, double farthestM) throws Exception {
    try (UgvDrive drive = start(without(services.split(" ")))) {
      requireTheLoop("without " + services, drive, farthestM);
    }
  }

  /** Nothing says where a vehicle starts, or where it looks at rest, but these. */
  @ParameterizedTest
  @CsvSource({"GpsSensor, 'state lacks x, y'", "CompassSensor ImuSensor, state lacks psi"})
  void absent_whatNoOtherMeasures_neverMovesAndSaysWhy(String services, String why)
      throws Exception {
    try (UgvDrive drive = start(without(services.split(" ")))) {
      drive.requireStanding(20.0);
    }
    assertThat(Files.readString(directory.resolve("logs/StateEstimator.log"), UTF_8)).contains(why);
  }
}
