package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.CompassSensor;
import org.u2sa.device.GpsSensor;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.sim.device.SimulatedCompass;
import org.u2sa.sim.device.SimulatedGps;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.testkit.Repository;
import org.u2sa.trials.run.RunPlans;
import org.u2sa.trials.run.VehicleTrial;

/**
 * The ground vehicle with its GPS and its compass as services of their own (thesis 4.6.3), and the
 * estimator that passes on. {@link SensorLossTest} drives them by the one that fuses.
 */
class SeparateSensorsTest {
  private static final String ESTIMATOR =
      "  <service class=\"org.u2sa.estimation.PassThroughStateEstimator\"";
  private static final String GPS = "  <service class=\"org.u2sa.device.GpsSensor\"/>\n";
  private static final String COMPASS = "  <service class=\"org.u2sa.device.CompassSensor\"/>\n";

  @TempDir Path directory;

  private final LockstepClock clock = new LockstepClock();
  private VehicleTrial vehicle;

  private RunningSystem start(String sensors) throws IOException {
    Path ugv = Repository.root().resolve("config/ugv");
    String system = Files.readString(ugv.resolve("system-pass-through.xml"), UTF_8);
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file,
        system
            .replace(ESTIMATOR, sensors + ESTIMATOR)
            .replace("configuration=\"", "configuration=\"" + ugv + "/"),
        UTF_8);
    Mission mission = Mission.load(Repository.root().resolve("missions/ugv/loop.xml"));
    RunPlan.Start start = RunPlans.start(mission);
    LocalPlane plane =
        new LocalPlane(new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.altitudeM()));
    NoiseStreams streams = new NoiseStreams(1);
    SimulatedGps gps =
        new SimulatedGps(GpsParameters.survey(), plane, streams, this::truth, () -> false);
    double declinationRad =
        MagneticModel.declinationRad(
            plane.origin().latitudeDeg(),
            plane.origin().longitudeDeg(),
            plane.origin().altitudeM(),
            MagneticModel.FIRST_YEAR);
    SimulatedCompass compass =
        new SimulatedCompass(
            CompassParameters.calibrated(declinationRad),
            streams,
            this::truth,
            CompassModel.Disturbance::none);
    System.setProperty("u2sa.home", Repository.root().toString());
    vehicle =
        UgvDrive.vehicle(
            mission, new UgvDrive.Scene(1, GpsGrade.SURVEY, Hazards.none(), List.of()));
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(1)
            .logDirectory(directory)
            .override("CommunicationManager", "BROKER", "none")
            .override("SafetyManager", "ARM AT START", true)
            .override("IoioService", "GPS RX PIN", -1)
            .override("IoioService", "GPS TX PIN", -1)
            .override("IoioService", "COMPASS RX PIN", -1)
            .override("IoioService", "COMPASS TX PIN", -1)
            .making(GpsSensor.class, context -> new GpsSensor(context, gps))
            .making(CompassSensor.class, context -> new CompassSensor(context, compass));
    vehicle.inLockstep(options, "");
    return RunningSystem.start(SystemFile.read(file), options);
  }

  private VehicleTruth truth() {
    return vehicle.truth();
  }

  private String log(String service) {
    try {
      return Files.readString(directory.resolve(service + ".log"), UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private long goalsCompleted() {
    return log("MissionManager").lines().filter(line -> line.endsWith("completed")).count();
  }

  @Test
  void gpsAndCompassApart_missionIsDrivenToItsEnd() throws Exception {
    try (RunningSystem running = start(GPS + COMPASS)) {
      for (int seconds = 0; seconds < 400 && goalsCompleted() < 6; seconds += 5) {
        clock.advance(Clock.micros(5.0));
      }
      assertThat(running.isRunning()).isTrue();
    }
    assertThat(goalsCompleted()).as(log("MissionManager")).isEqualTo(6);
    assertThat(log("StateEstimator")).doesNotContain("state lacks");
  }

  @Test
  void gpsWithoutCompass_standsAndTheEstimatorSaysWhy() throws Exception {
    try (RunningSystem running = start(GPS)) {
      GroundState began = vehicle.board().state();
      clock.advance(Clock.micros(15.0));
      assertThat(running.isRunning()).isTrue();
      assertThat(vehicle.board().state().eastM()).isEqualTo(began.eastM());
    }
    assertThat(log("StateEstimator"))
        .contains("state lacks psi: no source of heading on sensed-state (received: GpsSensor)");
  }
}
