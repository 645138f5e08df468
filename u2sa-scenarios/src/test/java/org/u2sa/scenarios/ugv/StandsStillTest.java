package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.scenarios.ugv.UgvDrive.Stop;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.DrivingHazard;
import org.u2sa.sim.ground.Hazards;

/**
 * The vehicle stops, and stays where it is, whatever made it stop: by truth, through the whole
 * chain of services, board and motors. How long and how far it takes is written down.
 */
@Timeout(240)
class StandsStillTest {
  /** From 1 m/s with the motors' controllers braking at neutral pulses; the least is 0.14 m. */
  private static final double BRAKED_M = 0.3;

  /** Without pulses the wheels coast: 0.9 m. */
  private static final double COASTED_M = 1.2;

  @TempDir private Path directory;

  private UgvDrive start(Hazards hazards) {
    return new UgvDrive(directory, hazards, true);
  }

  /** Into {@code target/ugv-stops.txt} of the module. */
  private static void report(String cause, Stop stop) throws IOException {
    Path folder = Files.createDirectories(Path.of("target"));
    Files.writeString(
        folder.resolve("ugv-stops.txt"),
        String.format(
            Locale.ROOT,
            "%s: motors off after %.2f s, stands after %.2f s and %.2f m%n",
            cause,
            stop.motorsOffS(),
            stop.standsS(),
            stop.wayM()),
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }

  private static EmergencyStop emergencyStop() {
    return new EmergencyStop().active(true).operator("Ann").reason("test");
  }

  @Test
  void emergencyStop_atFullSpeed_standsAndStaysThoughControlCommands()
      throws InterruptedException, IOException {
    try (UgvDrive drive = start(Hazards.none())) {
      drive.driveAtFullSpeed();
      drive.operator.say(Channels.EMERGENCY_STOP, emergencyStop());
      Stop stop = drive.stop(5.0);
      report("emergency stop", stop);

      assertThat(stop.motorsOffS()).isLessThanOrEqualTo(0.06); // 10 ms operator, 20 ms a pulse
      assertThat(stop.wayM()).isLessThan(BRAKED_M);
      drive.requireStanding(30.0);
      drive.operator.say(
          Channels.ARMING, new ArmCommand().requestId("1").arm(true).operator("Ann"));
      drive.requireStanding(10.0); // the stop was not cleared
    }
  }

  @Test
  void emergencyStop_turningOnTheSpot_standsAndStays() throws InterruptedException, IOException {
    try (UgvDrive drive = start(Hazards.none())) {
      drive.driveUntil("turns", () -> Math.abs(drive.state().yawRateRadPerS()) > 0.9, 60.0);
      drive.operator.say(Channels.EMERGENCY_STOP, emergencyStop());
      Stop stop = drive.stop(5.0);
      report("emergency stop in a turn", stop);

      assertThat(stop.wayM()).isLessThan(BRAKED_M);
      drive.requireStanding(30.0);
    }
  }

  @Test
  void board_losesPower_standsUntilItIsBack() throws InterruptedException, IOException {
    try (UgvDrive drive = start(Hazards.none())) {
      drive.driveAtFullSpeed();
      drive.vehicle.cable().power(false);
      Stop stop = drive.stop(5.0);
      report("board without power", stop);

      assertThat(stop.motorsOffS())
          .isLessThanOrEqualTo(0.15); // the motors' controllers miss pulses
      assertThat(stop.wayM()).isLessThan(COASTED_M);
      drive.requireStanding(20.0);

      drive.vehicle.cable().power(true);
      drive.driveUntil("drives on", () -> drive.state().forwardMps() > 0.5, 10.0);
    }
  }

  @Test
  void radio_switchedToManual_obeysTheSticksAlone() throws InterruptedException, IOException {
    Hazards manual =
        Hazards.none().with(new DrivingHazard.Manual(8.0, 40.0, DriveCommand.neutral()));
    try (UgvDrive drive = start(manual)) {
      drive.drive(8.0);
      Stop stop = drive.stop(5.0);
      report("manual switch, sticks neutral", stop);

      assertThat(stop.wayM()).isLessThan(BRAKED_M);
      drive.requireStanding(26.0 - stop.standsS());
    }
  }

  @Test
  void radio_silent_stands() throws InterruptedException, IOException {
    Hazards silence = Hazards.none().with(new DrivingHazard.RadioSilence(8.0, 30.0));
    try (UgvDrive drive = start(silence)) {
      drive.drive(8.0);
      Stop stop = drive.stop(5.0);
      report("radio silent", stop);

      assertThat(stop.wayM()).isLessThan(COASTED_M);
      drive.requireStanding(15.0);
    }
  }

  @Test
  void operator_lost_stopsForGood() throws InterruptedException, IOException {
    try (UgvDrive drive = start(Hazards.none())) {
      drive.operator.isThere(true);
      drive.driveAtFullSpeed();
      drive.drive(2.0);
      drive.operator.isThere(false);
      Stop stop = drive.stop(10.0);
      report("operator lost", stop);

      assertThat(stop.motorsOffS()).isBetween(4.0, 5.3); // OPERATOR DEADLINE
      assertThat(drive.operator.action()).isEqualTo(FailsafeAction.STOP);
      drive.operator.isThere(true);
      drive.requireStanding(30.0);
    }
  }

  @Test
  void satellites_lost_withoutOtherSensors_holdsAndGoesOnWhenTheyAreBack()
      throws InterruptedException, IOException {
    Hazards outage = Hazards.none().with(new DrivingHazard.GpsOutage(8.0, 30.0));
    Path system = UgvDrive.config().resolve("system-pass-through.xml");
    try (UgvDrive drive = new UgvDrive(directory, system, 1, outage, true)) {
      drive.drive(8.0);
      Stop stop = drive.stop(5.0);
      report("GPS lost", stop);

      assertThat(stop.motorsOffS()).isLessThan(2.5); // STALE AFTER, and braking from 1 m/s
      drive.requireStanding(15.0);
      assertThat(drive.operator.action()).isEqualTo(FailsafeAction.HOLD);
      assertThat(drive.operator.causes()).anyMatch(cause -> cause.startsWith("position"));
      drive.driveUntil("drives on", () -> drive.state().forwardMps() > 0.5, 20.0);
      assertThat(drive.operator.action()).isEqualTo(FailsafeAction.CONTINUE);
    }
  }

  @Test
  void satellites_lost_drivesOnByWheelsAndInertialSensor() throws InterruptedException {
    Hazards outage = Hazards.none().with(new DrivingHazard.GpsOutage(8.0, 60.0));
    try (UgvDrive drive = start(outage)) {
      drive.driveUntil("two waypoints", () -> drive.operator.goalsDone() == 2, 60.0);

      assertThat(drive.misses()).allSatisfy(miss -> assertThat(miss).isLessThan(0.6));
      assertThat(drive.operator.action()).isEqualTo(FailsafeAction.CONTINUE);
    }
  }

  @Test
  void nobodyArms_neverMoves() throws InterruptedException {
    try (UgvDrive drive = new UgvDrive(directory, Hazards.none(), false)) {
      drive.requireStanding(20.0);

      assertThat(drive.operator.armed()).isFalse();
      drive.operator.say(
          Channels.ARMING, new ArmCommand().requestId("1").arm(true).operator("Ann"));
      drive.driveAtFullSpeed();
    }
  }
}
