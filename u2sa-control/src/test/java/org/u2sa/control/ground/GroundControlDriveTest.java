package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.control.ControlSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.service.ServiceContext;

/** The controls of ground vehicles behind the real planner, over corners of 90 and 135 degrees. */
class GroundControlDriveTest {
  private static final double[][] CORNERS = {{20, 0}, {20, 15}, {5, 15}, {15, 30}, {-5, 20}};
  private static final Map<String, Object> PLANNER =
      Map.of("LOOK AHEAD", 1.2, "LOOK AHEAD TIME", 1.2, "AT END", "HOLD");
  private static final Map<String, Object> FOR_STEERING =
      Map.of(
          "LOOK AHEAD", 1.5,
          "LOOK AHEAD TIME", 1.2,
          "TURN ACCELERATION", 1.0,
          "TURN LAG", 0.3,
          "AT END", "STOP");
  private static final Map<String, Object> STEERED =
      Map.of("MAX SPEED", 3.0, "CRUISE SPEED", 1.2, "WHEELBASE", 0.6, "STEERING ANGLE", 28.0);
  private static final double COMPASS_ERROR_RAD = Math.toRadians(2.0);
  private static final double THRESHOLD_M = 0.5;
  private static final double HEAVY_LAG_S = 1.2;
  private static final double DRIVEN_WITHIN_S = 200.0;

  @TempDir private Path directory;

  private RoverDrive differential(Function<ServiceContext, ? extends ControlSystem> control) {
    return differential(control, 0.0, Map.of());
  }

  private RoverDrive differential(
      Function<ServiceContext, ? extends ControlSystem> control,
      double mismatch,
      Map<String, Object> variables) {
    return new RoverDrive(
        new KinematicRover(KinematicRover.differential(mismatch), COMPASS_ERROR_RAD),
        RoverDrive.mission(directory, THRESHOLD_M, CORNERS),
        PLANNER,
        control,
        variables);
  }

  private static void requireAllWithin(RoverDrive drive, double missM) {
    assertThat(drive.until(drive::isMissionOver, DRIVEN_WITHIN_S)).isTrue();
    for (double[] corner : CORNERS) {
      assertThat(drive.missM(corner)).as("%.0f, %.0f", corner[0], corner[1]).isLessThan(missM);
    }
  }

  private static void requireStanding(RoverDrive drive, double forS) {
    drive.track.clear();
    drive.until(() -> false, forS);
    assertThat(drive.track).allSatisfy(s -> assertThat(Math.abs(s.speed())).isLessThan(1.0e-3));
  }

  @Test
  void pursuit_fiveCorners_capturesAllStaysOnTheStraightsAndStandsAtTheLast() {
    try (RoverDrive drive = differential(DifferentialPursuitControl::new)) {
      drive.rover.heading = Math.toRadians(170.0); // the first waypoint is behind
      requireAllWithin(drive, THRESHOLD_M);
      assertThat(drive.crossTrackRmsM(2.0, CORNERS)).isLessThan(0.1);

      drive.until(() -> false, 10.0); // to the last waypoint itself
      requireStanding(drive, 20.0);
      assertThat(drive.missM(CORNERS[4])).isLessThan(0.2);
    }
  }

  @Test
  void pursuit_stationWithAHeading_turnsThereAndKeepsIt() throws IOException {
    Path mission =
        Files.writeString(
            directory.resolve("station.xml"),
            """
            <mission>
              <station>
                <x>%.9f</x>
                <y>%.9f</y>
                <horizontalThreshold>0.5</horizontalThreshold>
                <psi unit="deg">200</psi>
                <duration>5</duration>
              </station>
            </mission>
            """
                .formatted(
                    KinematicRover.ORIGIN.longitudeDeg(),
                    KinematicRover.ORIGIN.latitudeDeg() + 5e-5));
    try (RoverDrive drive =
        new RoverDrive(
            new KinematicRover(KinematicRover.differential(0.0), 0.0),
            mission,
            PLANNER,
            DifferentialPursuitControl::new,
            Map.of())) {
      assertThat(drive.until(drive::isMissionOver, 60.0)).isTrue();
      double offRad = Math.IEEEremainder(drive.rover.heading - Math.toRadians(200.0), 2 * Math.PI);
      assertThat(Math.toDegrees(offRad)).isBetween(-3.0, 3.0);
    }
  }

  @Test
  void pursuit_motorsThatAreNotAlike_feedbackHoldsTheLine() {
    try (RoverDrive drive = differential(DifferentialPursuitControl::new, 0.05, Map.of());
        RoverDrive without =
            differential(DifferentialPursuitControl::new, 0.05, Map.of("TURN GAIN", 0.0))) {
      requireAllWithin(drive, THRESHOLD_M);
      requireAllWithin(without, 2.0 * THRESHOLD_M);

      assertThat(drive.crossTrackRmsM(2.0, CORNERS))
          .isLessThan(0.5 * without.crossTrackRmsM(2.0, CORNERS));
    }
  }

  @Test
  void pursuit_heavyVehicle_pickUpTimesTurnItInTime() {
    try (RoverDrive drive =
            differential(
                DifferentialPursuitControl::new,
                0.0,
                Map.of("PICK UP TIME", HEAVY_LAG_S, "TURN PICK UP TIME", HEAVY_LAG_S));
        RoverDrive without = differential(DifferentialPursuitControl::new)) {
      drive.rover.lagS = HEAVY_LAG_S;
      without.rover.lagS = HEAVY_LAG_S;
      requireAllWithin(drive, THRESHOLD_M);
      without.until(without::isMissionOver, DRIVEN_WITHIN_S);

      assertThat(drive.crossTrackRmsM(2.0, CORNERS))
          .isLessThan(0.5 * without.crossTrackRmsM(2.0, CORNERS));
    }
  }

  @Test
  void proportional_fiveCorners_capturesAll() {
    try (RoverDrive drive = differential(DifferentialDriveControl::new)) {
      requireAllWithin(drive, 2.0 * THRESHOLD_M); // it does not slow down to turn
      assertThat(drive.crossTrackRmsM(2.0, CORNERS)).isLessThan(0.5);
    }
  }

  @Test
  void ackermann_fiveCorners_capturesAll() {
    try (RoverDrive drive = ackermann(FOR_STEERING, STEERED)) {
      requireAllWithin(drive, 1.0);
      assertThat(drive.crossTrackRmsM(4.0, CORNERS)).isLessThan(0.4); // it swings out at corners
      drive.until(() -> false, 3.0);
      requireStanding(drive, 5.0);
    }
  }

  @Test
  void steersByAngle_fiveCorners_isTheSameDrive() {
    Map<String, Object> variables = new HashMap<>(STEERED);
    try (RoverDrive byPercent = ackermann(PLANNER, variables)) {
      byPercent.until(() -> false, 40.0);
      variables.put("STEERS BY ANGLE", true);
      try (RoverDrive byAngle = ackermann(PLANNER, variables)) {
        byAngle.until(() -> false, 40.0);

        List<AngleCommand> angles = new ArrayList<>();
        byAngle.kit.published(Channels.ACTUATION).stream()
            .filter(AngleCommand.class::isInstance)
            .forEach(each -> angles.add((AngleCommand) each));
        assertThat(angles).extracting(AngleCommand::actuatorName).containsOnly("STEERING");
        assertThat(angles)
            .extracting(AngleCommand::angle)
            .anySatisfy(angle -> assertThat(angle).isGreaterThan(0.2))
            .allSatisfy(
                angle ->
                    assertThat(Math.abs(angle)).isLessThanOrEqualTo(RoverDrive.FULL_ANGLE_RAD));
        RoverDrive.Sample end = byAngle.track.get(byAngle.track.size() - 1);
        RoverDrive.Sample same = byPercent.track.get(byPercent.track.size() - 1);
        assertThat(end.north()).isCloseTo(same.north(), within(1e-6));
        assertThat(end.east()).isCloseTo(same.east(), within(1e-6));
        assertThat(end.goalsDone()).isGreaterThanOrEqualTo(2);
      }
    }
  }

  @Test
  void stanley_fiveCorners_capturesAllAndStaysOnTheLegs() {
    Map<String, Object> stanley = new HashMap<>(STEERED);
    stanley.put("STEERING LAW", "STANLEY");
    try (RoverDrive drive = ackermann(FOR_STEERING, stanley)) {
      requireAllWithin(drive, 1.0);
      assertThat(drive.crossTrackRmsM(4.0, CORNERS)).isLessThan(0.35); // the sharp corner again
    }
  }

  private RoverDrive ackermann(Map<String, Object> planner, Map<String, Object> variables) {
    return new RoverDrive(
        new KinematicRover(KinematicRover.ackermann(), COMPASS_ERROR_RAD),
        RoverDrive.mission(directory, 1.0, CORNERS),
        planner,
        AckermannPursuitControl::new,
        variables);
  }

  @Test
  void position_lost_brakesAtOnceAndGoesOnWhenItIsBack() {
    try (RoverDrive drive = differential(DifferentialPursuitControl::new)) {
      drive.until(() -> false, 8.0);
      assertThat(drive.rover.speed).isGreaterThan(0.9);
      double lostAtM = drive.rover.north;
      drive.measures = false;
      drive.until(() -> false, 2.5);
      assertThat(drive.rover.north - lostAtM).isLessThan(1.0); // v²/2a and the motors' lag
      requireStanding(drive, 5.0);

      drive.measures = true;
      assertThat(drive.until(drive::isMissionOver, DRIVEN_WITHIN_S)).isTrue();
    }
  }

  @Test
  void motor_lost_isNotDrivenAgainstAndItDrivesOnGentlyWhenItIsBack() {
    for (Function<ServiceContext, ControlSystem> control :
        List.<Function<ServiceContext, ControlSystem>>of(
            DifferentialPursuitControl::new, DifferentialDriveControl::new)) {
      try (RoverDrive drive = differential(control)) {
        drive.until(() -> false, 8.0);
        drive.announce("RIGHT MOTOR", 0.0);
        drive.until(() -> false, 2.5);
        requireStanding(drive, 20.0);
        assertThat(drive.percent("LEFT MOTOR")).isZero();

        drive.announce("RIGHT MOTOR", 60.0); // weak is not lost
        assertThat(drive.until(() -> drive.rover.speed > 0.5, 2.0)).isTrue();
      }
    }
  }

  @Test
  void motors_withheldByARadio_areNotDrivenAgainstAndItDrivesOnGently() {
    for (Function<ServiceContext, ControlSystem> control :
        List.<Function<ServiceContext, ControlSystem>>of(
            DifferentialPursuitControl::new, DifferentialDriveControl::new)) {
      try (RoverDrive drive = differential(control)) {
        drive.until(() -> false, 8.0);
        drive.withhold(true);
        drive.until(() -> false, 2.5);
        requireStanding(drive, 3.0);

        drive.withhold(false);
        assertThat(drive.until(() -> drive.rover.speed > 0.5, 2.0)).isTrue();
      }
    }
  }

  @Test
  void steering_lost_standsUntilItIsBack() {
    try (RoverDrive drive =
        new RoverDrive(
            new KinematicRover(KinematicRover.ackermann(), COMPASS_ERROR_RAD),
            RoverDrive.mission(directory, THRESHOLD_M, CORNERS),
            PLANNER,
            AckermannPursuitControl::new,
            Map.of())) {
      drive.until(() -> false, 8.0);
      drive.announce("STEERING", 0.0);
      drive.until(() -> false, 2.5);
      requireStanding(drive, 5.0);

      drive.announce("STEERING", 100.0);
      assertThat(drive.until(() -> drive.rover.speed > 0.5, 3.0)).isTrue();
    }
  }

  @Test
  void swap_betweenTheControlsWhileDriving_staysOnTheLineWithoutAJerk() {
    try (RoverDrive drive = differential(DifferentialPursuitControl::new)) {
      drive.until(() -> drive.goalsDone() == 1, 60.0);
      drive.until(() -> false, 8.0); // on the second leg, along east
      for (int swaps = 0; swaps < 3; swaps++) {
        drive.swap(DifferentialDriveControl::new);
        requireSteady(drive);
        drive.swap(DifferentialPursuitControl::new);
        requireSteady(drive);
      }
      requireAllWithin(drive, THRESHOLD_M);
    }
  }

  private static void requireSteady(RoverDrive drive) {
    double left = drive.percent("LEFT MOTOR");
    double right = drive.percent("RIGHT MOTOR");
    drive.until(() -> false, 0.1);
    assertThat(drive.percent("LEFT MOTOR")).isBetween(left - 12.0, left + 12.0);
    assertThat(drive.percent("RIGHT MOTOR")).isBetween(right - 12.0, right + 12.0);
    drive.until(() -> false, 0.9);
    assertThat(drive.rover.north).isBetween(19.7, 20.3);
    assertThat(drive.rover.speed).isGreaterThan(0.6);
  }
}
