package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.mission.Mission;
import org.u2sa.drivers.compass.Compass;
import org.u2sa.drivers.compass.CompassSensor;
import org.u2sa.drivers.compass.Heading;
import org.u2sa.drivers.gps.GpsFix;
import org.u2sa.drivers.gps.GpsReceiver;
import org.u2sa.drivers.gps.GpsSensor;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.scenarios.run.RunPlans;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.Hazards;

/**
 * The ground vehicle with its GPS and its compass as services of their own (thesis 4.6.3), and
 * everything else as it is shipped.
 */
class SeparateSensorsTest {
  private static final String ESTIMATOR =
      "  <service class=\"org.u2sa.core.estimation.PassThroughStateEstimator\"";
  private static final String GPS = "  <service class=\"org.u2sa.drivers.gps.GpsSensor\"/>\n";
  private static final String COMPASS =
      "  <service class=\"org.u2sa.drivers.compass.CompassSensor\"/>\n";

  @TempDir Path directory;

  private final LockstepClock clock = new LockstepClock();
  private UgvWorld world;

  private RunningSystem start(String sensors) throws IOException {
    Path ugv = UgvCommandLine.repository().resolve("config/ugv");
    String system = Files.readString(ugv.resolve("system.xml"), UTF_8);
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file,
        system
            .replace(ESTIMATOR, sensors + ESTIMATOR)
            .replace("configuration=\"", "configuration=\"" + ugv + "/"),
        UTF_8);
    Mission mission = Mission.load(UgvCommandLine.repository().resolve("missions/ugv/loop.xml"));
    world =
        new UgvWorld(
            RunPlans.start(mission),
            VehicleKind.DIFFERENTIAL,
            GpsGrade.SURVEY,
            1,
            Hazards.none(),
            DriveConditions.usual());
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
            .making(IoioService.class, context -> new IoioService(context, world.connection()))
            .making(GpsSensor.class, context -> new GpsSensor(context, new TrueGps(world)))
            .making(
                CompassSensor.class, context -> new CompassSensor(context, new TrueCompass(world)));
    return RunningSystem.start(SystemFile.read(file), options);
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
      GroundState began = world.state();
      clock.advance(Clock.micros(15.0));
      assertThat(running.isRunning()).isTrue();
      assertThat(world.state().eastM()).isEqualTo(began.eastM());
    }
    assertThat(log("StateEstimator"))
        .contains("state lacks psi: no source of heading on sensed-state (heard: GpsSensor)");
  }

  /** A receiver that is up to 2 cm wrong, five times a second. */
  private static final class TrueGps implements GpsReceiver {
    private static final long PERIOD_MICROS = 200_000;
    private static final double SIGMA_M = 0.02;

    private final UgvWorld world;
    private final SplittableRandom random = new SplittableRandom(3);
    private Optional<GpsFix> fix = Optional.empty();

    TrueGps(UgvWorld world) {
      this.world = world;
    }

    @Override
    public Reading read(long nowMicros) {
      boolean isDue = fix.isEmpty() || nowMicros - fix.get().measuredAtMicros() >= PERIOD_MICROS;
      if (isDue) {
        GroundState truth = world.state();
        Geodetic place = world.world().groundAt(truth.eastM(), truth.northM());
        double offDeg = (random.nextDouble() - 0.5) * 2.0 * SIGMA_M / 111_000.0;
        OptionalDouble sigma = OptionalDouble.of(SIGMA_M);
        fix =
            Optional.of(
                new GpsFix(
                    nowMicros,
                    place.latitudeDeg() + offDeg,
                    place.longitudeDeg() - offDeg,
                    OptionalDouble.of(place.altitudeM()),
                    OptionalDouble.of(truth.eastMps()),
                    OptionalDouble.of(truth.northMps()),
                    OptionalDouble.of(0.0),
                    sigma,
                    sigma,
                    9,
                    true));
      }
      return new Reading(true, fix);
    }

    @Override
    public long malformed() {
      return 0;
    }

    @Override
    public boolean isConnected() {
      return true;
    }

    @Override
    public int connections() {
      return 1;
    }

    @Override
    public String trouble() {
      return "";
    }

    @Override
    public void close() {
      // holds nothing
    }
  }

  /** A compass that knows true north, at each step. */
  private static final class TrueCompass implements Compass {
    private final UgvWorld world;

    TrueCompass(UgvWorld world) {
      this.world = world;
    }

    @Override
    public Reading read(long nowMicros) {
      double headingRad = world.state().headingRad() % (2.0 * Math.PI);
      double positive = headingRad < 0.0 ? headingRad + 2.0 * Math.PI : headingRad;
      return new Reading(true, Optional.of(new Heading(nowMicros, positive, true)));
    }

    @Override
    public long malformed() {
      return 0;
    }

    @Override
    public boolean isConnected() {
      return true;
    }

    @Override
    public int connections() {
      return 1;
    }

    @Override
    public String trouble() {
      return "";
    }

    @Override
    public void close() {
      // holds nothing
    }
  }
}
