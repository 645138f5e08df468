package org.u2sa.control.ground;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Follows the navigation points of a differential ground vehicle by regulated pure pursuit, with
 * turns in place (the default for thesis 4.6.2.5). In: navigation, state. Out: actuation of the
 * left and the right motor, once per state, or once per navigation point while no states arrive.
 * Without fresh navigation the vehicle brakes to a stop.
 */
public final class DifferentialPursuitControl extends GroundControl {
  /** Turn settings. */
  private record Turning(
      @Variable(unit = "m", min = 0.05, max = 10, ifAbsent = 0.44)
          @Description("Distance between the wheels of both sides.")
          double track,
      @Variable(unit = "s", min = 0, max = 10, ifAbsent = 0)
          @Description("Like PICK UP TIME, for the yaw rate in a turn in place.")
          double turnPickUpTime,
      @Variable(unit = "deg", min = 5, max = 180, ifAbsent = 35)
          @Description("Bearing of the navigation point above which the vehicle turns in place.")
          double spotTurnAbove,
      @Variable(unit = "deg", min = 1, max = 180, ifAbsent = 8)
          @Description("Bearing at which a turn in place ends.")
          double spotTurnBelow,
      @Variable(unit = "1/s", min = 0.1, max = 20, ifAbsent = 2)
          @Description("Yaw rate per bearing in a turn in place.")
          double spotTurnGain,
      @Variable(unit = "1/s", min = 0, max = 10, ifAbsent = 2)
          @Description(
              "Share of a yaw-rate error that feedback corrects per second while turning in place; 0: no feedback.")
          double spotTurnFeedback,
      @Variable(min = 1, max = 20, ifAbsent = 3.2)
          @Description(
              "Limit of a turn in place with feedback, as a multiple of the calibrated command at TURN RATE; more for wheels that scrub under load.")
          double spotTurnBoost,
      @Variable(min = 0, max = 10, ifAbsent = 2)
          @Description("Additional commanded yaw rate per yaw-rate error; 0: none.")
          double yawRateGain) {}

  private static final double FULL_PERCENT = 100.0;
  private static final double TIGHTEST = 10.0; // [1/m]; tighter is effectively a turn in place

  private final Settings<PursuitVariables> tuning = settings(PursuitVariables.class);
  private final Settings<Turning> turning = settings(Turning.class);
  private final Settings<SlopeHelp> slopes = settings(SlopeHelp.class);
  private final Settings<Motors> motors = settings(Motors.class);
  private final InertiaFeedForward turnPickUp = new InertiaFeedForward();
  private final WheelBalance balance = new WheelBalance();
  private final PursuitControl pursuit = new PursuitControl(tuning, pursuitSettings());

  public DifferentialPursuitControl(ServiceContext context) {
    super(context);
  }

  private PursuitSettings pursuitSettings() {
    Turning now = turning.get();
    return new PursuitSettings(
        tuning.get(),
        TIGHTEST,
        new PursuitSettings.SpotTurn(
            true,
            Math.toRadians(now.spotTurnAbove()),
            Math.toRadians(Math.min(now.spotTurnBelow(), now.spotTurnAbove())),
            now.spotTurnGain()));
  }

  /** Applies new gains and limits while driving. */
  @Override
  protected void configurationChanged(Set<String> variableNames) {
    pursuit.settings(pursuitSettings());
  }

  @Override
  List<String> motors() {
    return motors.get().names();
  }

  @Override
  protected boolean obeysWithoutState() {
    return true;
  }

  @Override
  void coasted(double seconds) {
    pursuit.coasted(seconds);
  }

  @Override
  void drive(StateInformation state, Optional<GroundTarget> target, Measured measured) {
    PursuitControl.Demand demand = pursuit.step(target, measured, stepS());
    pursuit
        .commanded(demand, drive(demand, state), measured, stepS())
        .ifPresent(
            words -> {
              boolean isBounded = isTurnInPlace(demand.drive()) && mostTurning() < 1.0;
              unmoved(isBounded ? words + "; SPOT TURN BOOST limits the power" : words);
              balance.relax();
            });
  }

  /**
   * Commands the motors; returns the demand as a fraction of their capability, or of the limit in a
   * turn in place.
   */
  private double drive(PursuitControl.Demand demand, StateInformation state) {
    DriveCalibration motor = tuning.get().calibration();
    Drive drive = demand.drive();
    double turn = turnPickUp.step(drive.yawRateRadPerS(), turning.get().turnPickUpTime(), stepS());
    Drive told =
        drive.isStanding()
            ? drive
            : new Drive(drive.speedMps() + demand.moreMps(), drive.yawRateRadPerS() + turn);
    WheelSpeeds wheels = WheelSpeeds.of(told, turning.get().track(), motor.maxMps());
    double slope = drive.isStanding() ? 0.0 : slopes.get().share(state);
    WheelShares shares =
        balance.step(
            new WheelShares(
                motor.share(wheels.leftMps()) + slope, motor.share(wheels.rightMps()) + slope),
            drive.speedMps() != 0.0 ? motor.share(told.speedMps()) + slope : 0.0,
            demand.yawErrorRadPerS(),
            feedback(motor),
            stepS());
    WheelShares possible = shares.possible();
    commandShare(motors.get().leftActuator(), possible.left());
    commandShare(motors.get().rightActuator(), possible.right());
    return shares.effort() / (isTurnInPlace(drive) ? mostTurning() : 1.0);
  }

  private static boolean isTurnInPlace(Drive drive) {
    return !drive.isStanding() && drive.speedMps() == 0.0;
  }

  /** Limit of the command in a turn in place, as a fraction of full command. */
  private double mostTurning() {
    DriveCalibration motor = tuning.get().calibration();
    double wheelMps = 0.5 * turning.get().track() * tuning.get().turnRateRadPerS();
    return Math.min(1.0, turning.get().spotTurnBoost() * motor.share(wheelMps));
  }

  private WheelBalance.Settings feedback(DriveCalibration motor) {
    return new WheelBalance.Settings(
        turning.get().yawRateGain(),
        0.5 * tuning.get().responseTime(),
        tuning.get().turnGain(),
        turning.get().spotTurnFeedback(),
        motors.get().mismatchLimit() / FULL_PERCENT,
        0.5 * turning.get().track() * (1.0 - motor.startShare()) / motor.maxMps(),
        tuning.get().turnRateRadPerS(),
        mostTurning());
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    pursuit.handOver(state);
    balance.transfer(Transfer.saving(state));
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    balance.takeOver(state, isSwap());
    if (isSwap()) {
      pursuit.takeOver(state, isOfMyClass(state), lastDrive());
    }
  }

  /** Motion last commanded to the motors, by any control system. */
  private Drive lastDrive() {
    DriveCalibration motor = tuning.get().calibration();
    return new WheelSpeeds(
            motor.speedMps(lastShare(motors.get().leftActuator())),
            motor.speedMps(lastShare(motors.get().rightActuator())))
        .drive(turning.get().track());
  }
}
