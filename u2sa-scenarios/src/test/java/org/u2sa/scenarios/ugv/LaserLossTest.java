package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.device.LidarSensor;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.testkit.Repository;
import org.u2sa.world.xml.WorldFile;

/** The shipped loop among obstacles; the laser or the World Modeler fails. */
class LaserLossTest {
  /** Less than to the first obstacle; with the laser dead it drove into one after 29.8 s. */
  private static final double FAILS_S = 10.0;

  private static final double STANDS_WITHIN_S = 2.5; // SILENT AFTER or WORLD STALE AFTER, braking

  @TempDir private Path directory;
  private UgvDrive drive;
  private boolean silent;

  private void start(Consumer<LaunchOptions> more) {
    Path world = Repository.root().resolve("missions/ugv/obstructed.xml");
    drive =
        new UgvDrive(
            directory,
            UgvDrive.config().resolve("system-world.xml"),
            new UgvDrive.Scene(1, GpsGrade.SURVEY, Hazards.none(), WorldFile.load(world).objects()),
            true,
            options -> {
              options.making(
                  LidarSensor.class, context -> new LidarSensor(context, laser(context)));
              more.accept(options);
            });
  }

  /** It repeats its last scan while it is lost, as {@link LaserScanner} demands. */
  private LaserScanner laser(ServiceContext context) {
    return new LaserScanner() {
      private LaserScanner real; // the simulated one exists after the start
      private Optional<Scan> last = Optional.empty();

      @Override
      public Optional<Scan> read(long micros) {
        if (drive != null && !silent) {
          real = real == null ? drive.laser(context) : real;
          last = real.read(micros);
        }
        return last;
      }

      @Override
      public boolean isConnected() {
        return !silent;
      }

      @Override
      public String trouble() {
        return silent ? "nothing comes" : "";
      }
    };
  }

  private static void healthMonitorOnlyAlerts(LaunchOptions options) {
    options.override("HealthMonitor", "LidarSensor POLICY", "ALERT");
  }

  @AfterEach
  void close() {
    drive.close();
  }

  private double speedMps() {
    return Math.abs(drive.state().forwardMps());
  }

  private void expectStandingFor(double seconds) throws InterruptedException {
    drive.driveUntil("stands", () -> speedMps() < 0.01, STANDS_WITHIN_S);
    double there = drive.state().northM();
    drive.drive(seconds);
    assertThat(drive.state().northM() - there).isBetween(-0.05, 0.05);
    assertThat(drive.contacts()).isZero();
  }

  @Test
  void laserFallsSilent_shippedFiles_stopsByFailsafe() throws InterruptedException {
    start(options -> {});
    drive.drive(FAILS_S);
    assertThat(speedMps()).isGreaterThan(0.5);
    silent = true;
    expectStandingFor(20.0);
    assertThat(drive.operator.action()).isEqualTo(FailsafeAction.STOP);
    assertThat(drive.operator.causes().toString()).contains("LidarSensor is STALLED");
  }

  @Test
  void laserFallsSilent_noFailsafe_plannerStandsAndGoesOnWithTheLaser()
      throws InterruptedException {
    start(LaserLossTest::healthMonitorOnlyAlerts);
    drive.drive(FAILS_S);
    silent = true;
    expectStandingFor(20.0);
    assertThat(drive.operator.action()).isEqualTo(FailsafeAction.CONTINUE);

    silent = false;
    drive.driveUntil("goes on", () -> speedMps() > 0.5, 5.0);
  }

  @Test
  void worldModelerIsGone_plannerStands() throws InterruptedException {
    start(options -> {});
    drive.drive(FAILS_S);
    drive.kill("WorldModeler");
    expectStandingFor(10.0);
  }

  @Test
  void laserIsDeadFromTheStart_isNotArmed() throws InterruptedException {
    silent = true;
    start(options -> {});
    drive.drive(20.0);
    assertThat(drive.state().northM()).isBetween(-2.0, 2.0);
    assertThat(speedMps()).isLessThan(0.01);
    assertThat(drive.operator.armed()).isFalse();
  }

  @Test
  void laserIsDeadFromTheStart_armedAllTheSame_plannerStands() throws InterruptedException {
    silent = true;
    start(
        options -> {
          healthMonitorOnlyAlerts(options);
          options.override("HealthMonitor", "WATCHED", "IoioService, StateEstimator");
        });
    drive.drive(20.0);
    assertThat(drive.operator.armed()).isTrue();
    assertThat(speedMps()).isLessThan(0.01);
  }
}
