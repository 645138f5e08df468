package org.u2sa.scenarios.cessna;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.testkit.Repository;

/** A line in the system file adds a sensor to the Cessna, and it rolls all the same. */
class AddedAircraftSensorsTest {
  private static final String ESTIMATOR = "  <service class=\"org.u2sa.estimation.";

  @TempDir Path directory;

  @ParameterizedTest
  @ValueSource(strings = {"BarometerSensor", "AirspeedSensor", "GpsSensor", "ImuSensor"})
  void run_sensorAdded_theControlKnowsThatItStandsOnItsWheels(String sensor) throws Exception {
    Path home = Repository.root();
    Path cessna = home.resolve("config/cessna");
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file,
        Files.readString(cessna.resolve("system.xml"), UTF_8)
            .replace(
                ESTIMATOR, "  <service class=\"org.u2sa.device." + sensor + "\"/>\n" + ESTIMATOR)
            .replace("configuration=\"", "configuration=\"" + cessna + "/"),
        UTF_8);
    LockstepClock clock = new LockstepClock();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(1)
            .logDirectory(directory)
            .override("CommunicationManager", "BROKER", "none")
            .override("SafetyManager", "ARM AT START", true);
    options.devices(
        TroubledFlight.devices(
            home.resolve("missions/cessna/mission.xml"), DemoWind.parse("calm"), 1));
    try (RunningSystem running = RunningSystem.start(SystemFile.read(file), options)) {
      clock.advance(Clock.micros(5.0));
      assertThat(running.isRunning()).isTrue();
    }
    assertThat(Files.readString(directory.resolve("Control.log"), UTF_8))
        .containsSubsequence("phase RUN_UP", "phase ROLL")
        .doesNotContain("phase HOLD");
    assertThat(Files.readString(directory.resolve(sensor + ".log"), UTF_8))
        .doesNotContain("is lost");
  }
}
