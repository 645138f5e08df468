package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.mission.Mission;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.testkit.Repository;
import org.u2sa.trials.run.VehicleTrial;

/**
 * A line in the system file adds a sensor, and the vehicle goes on (thesis 5.1, story 9): with the
 * estimator that passes on and with the one that fuses.
 */
class AddedSensorsTest {
  private static final String ESTIMATOR = "  <service class=\"org.u2sa.estimation.";

  @TempDir Path directory;

  private final LockstepClock clock = new LockstepClock();

  private RunningSystem start(String base, String services) throws IOException {
    Path ugv = Repository.root().resolve("config/ugv");
    StringBuilder lines = new StringBuilder();
    for (String each : services.split(" ")) {
      lines.append("  <service class=\"org.u2sa.device.").append(each).append("\"/>\n");
    }
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file,
        Files.readString(ugv.resolve(base), UTF_8)
            .replace(ESTIMATOR, lines + ESTIMATOR) // so that the Safety Manager looks after them
            .replace("configuration=\"", "configuration=\"" + ugv + "/"),
        UTF_8);
    Mission mission = Mission.load(Repository.root().resolve("missions/ugv/loop.xml"));
    System.setProperty("u2sa.home", Repository.root().toString());
    VehicleTrial vehicle =
        UgvDrive.vehicle(
            mission, new UgvDrive.Scene(1, GpsGrade.SURVEY, Hazards.none(), List.of()));
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(1)
            .logDirectory(directory)
            .override("CommunicationManager", "BROKER", "none")
            .override("SafetyManager", "ARM AT START", true)
            .devices(vehicle.devices());
    vehicle.inLockstep(options, "");
    return RunningSystem.start(SystemFile.read(file), options);
  }

  private String log(String service) throws IOException {
    return Files.readString(directory.resolve(service + ".log"), UTF_8);
  }

  private long goalsCompleted() throws IOException {
    return log("MissionManager").lines().filter(line -> line.endsWith("completed")).count();
  }

  private void drive(String base, String services, int goals) throws Exception {
    try (RunningSystem running = start(base, services)) {
      for (int seconds = 0; seconds < 300 && goalsCompleted() < goals; seconds += 5) {
        clock.advance(Clock.micros(5.0));
      }
      assertThat(running.isRunning()).isTrue();
    }
    assertThat(goalsCompleted()).as(log("PathPlanner")).isGreaterThanOrEqualTo(goals);
  }

  /** Speeds in BODY once took the position's place: "state lacks x or y", and it stood for good. */
  @Test
  void run_encodersAddedToTheEstimatorThatPassesOn_goesOn() throws Exception {
    drive("system-pass-through.xml", "WheelEncoderSensor", 1);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "system-pass-through.xml, ImuSensor",
    "system-pass-through.xml, BarometerSensor",
    "system-pass-through.xml, GpsSensor",
    "system-pass-through.xml, ImuSensor WheelEncoderSensor BarometerSensor CompassSensor",
    "system-board.xml, ImuSensor",
    "system-board.xml, WheelEncoderSensor",
    "system-board.xml, BarometerSensor",
    "system-board.xml, GpsSensor",
    "system-board.xml, ImuSensor WheelEncoderSensor BarometerSensor CompassSensor"
  })
  void run_sensorsAdded_missionIsDrivenToItsEnd(String base, String services) throws Exception {
    drive(base, services, 6);
  }
}
