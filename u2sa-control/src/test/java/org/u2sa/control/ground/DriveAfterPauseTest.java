package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.control.ControlSystem;
import org.u2sa.service.ServiceContext;

/** Ground vehicles drive off after a time in which their motors did not obey. */
class DriveAfterPauseTest {
  private static final double CRUISE_MPS = 1.0;
  private static final double ACCELERATION_MPS2 = 0.8;
  private static final double HALF_S = 0.5;

  @TempDir private Path directory;

  private interface Constructor extends Function<ServiceContext, ControlSystem> {}

  static Stream<Arguments> controls() {
    Constructor differential = DifferentialPursuitControl::new;
    Constructor ackermann = AckermannPursuitControl::new;
    return Stream.of(
        Arguments.of(differential, KinematicRover.differential(0.0), 2.0),
        Arguments.of(ackermann, KinematicRover.ackermann(), 3.0));
  }

  private RoverDrive drive(
      Constructor control, KinematicRover.Kinematics kinematics, double maxMps) {
    RoverDrive drive =
        new RoverDrive(
            new KinematicRover(kinematics, 0.0),
            RoverDrive.mission(directory, 0.5, new double[] {60.0, 0.0}),
            Map.of("LOOK AHEAD", 1.2, "LOOK AHEAD TIME", 1.2, "AT END", "STOP"),
            control,
            Map.of(
                "MAX SPEED",
                maxMps,
                "CRUISE SPEED",
                CRUISE_MPS,
                "ACCELERATION",
                ACCELERATION_MPS2,
                "START PERCENTAGE",
                maxMps == 2.0 ? 8.0 : 0.0));
    drive.until(() -> false, 8.0);
    assertThat(drive.rover.speed).isGreaterThan(0.9 * CRUISE_MPS);
    return drive;
  }

  private static void requireGentleStart(RoverDrive drive) {
    assertThat(drive.rover.speed).isLessThan(0.1);
    drive.until(() -> false, HALF_S);
    assertThat(drive.rover.speed).isLessThan(ACCELERATION_MPS2 * HALF_S + 0.05);
    drive.track.clear();
    drive.until(() -> false, 5.0);
    assertThat(drive.rover.speed).isGreaterThan(0.9 * CRUISE_MPS);
    assertThat(drive.track).allSatisfy(s -> assertThat(s.speed()).isLessThan(1.1 * CRUISE_MPS));
  }

  @ParameterizedTest
  @MethodSource("controls")
  void control_statesPausedUntilCommandsExpired_acceleratesAsFromRest(
      Constructor control, KinematicRover.Kinematics kinematics, double maxMps) {
    try (RoverDrive drive = drive(control, kinematics, maxMps)) {
      drive.freeze(3.0);
      requireGentleStart(drive);
    }
  }

  @ParameterizedTest
  @MethodSource("controls")
  void control_armedAgain_acceleratesAsFromRest(
      Constructor control, KinematicRover.Kinematics kinematics, double maxMps) {
    try (RoverDrive drive = drive(control, kinematics, maxMps)) {
      drive.disarmed(3.0);
      requireGentleStart(drive);
    }
  }

  @ParameterizedTest
  @MethodSource("controls")
  void control_statesPausedBriefly_goesOnFromTheSpeedItStillHas(
      Constructor control, KinematicRover.Kinematics kinematics, double maxMps) {
    try (RoverDrive drive = drive(control, kinematics, maxMps)) {
      drive.until(() -> false, 0.2);
      drive.freeze(0.1); // longer than a step, shorter than COMMAND EXPIRY
      drive.track.clear();
      drive.until(() -> false, 2.0);
      assertThat(drive.track)
          .allSatisfy(s -> assertThat(s.speed()).isBetween(0.5 * CRUISE_MPS, 1.1 * CRUISE_MPS));
    }
  }
}
