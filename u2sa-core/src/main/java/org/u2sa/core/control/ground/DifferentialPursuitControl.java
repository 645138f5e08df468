package org.u2sa.core.control.ground;

import static org.u2sa.core.control.ground.PursuitVariables.number;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/**
 * Drives a differential ground vehicle along its navigation points by regulated pure pursuit, with
 * turns on the spot (the default for thesis 4.6.2.5). In: navigation, state. Out: actuation of the
 * left and the right motor, once for each state. Without fresh navigation, or without knowing where
 * it is, the vehicle brakes and stands.
 */
public final class DifferentialPursuitControl extends ControlSystem {
  static final VariableDeclaration<Double> TRACK =
      number("TRACK", "m", 0.05, 10.0, 0.44, "Distance between the wheels of both sides.");
  static final VariableDeclaration<Double> SPOT_TURN_ABOVE =
      number(
          "SPOT TURN ABOVE",
          "deg",
          5.0,
          180.0,
          35.0,
          "Direction of the point to go to from which on the vehicle turns on the spot.");
  static final VariableDeclaration<Double> SPOT_TURN_BELOW =
      number(
          "SPOT TURN BELOW",
          "deg",
          1.0,
          180.0,
          8.0,
          "Direction of the point at which it has turned enough.");
  static final VariableDeclaration<Double> SPOT_TURN_GAIN =
      number("SPOT TURN GAIN", "1/s", 0.1, 20.0, 2.0, "Yaw rate for each radian of direction.");

  static final VariableDeclaration<Double> SPOT_TURN_FEEDBACK =
      number(
          "SPOT TURN FEEDBACK",
          "1/s",
          0.0,
          10.0,
          2.0,
          "Share of an error of the yaw rate that feedback takes out in a second while it turns on the spot; 0: no feedback.");

  private static final double FULL_PERCENT = 100.0;
  private static final double TIGHTEST = 10.0; // [1/m]; tighter is as good as on the spot

  private final GroundControl ground = new GroundControl(this);
  private final WheelBalance balance = new WheelBalance();
  private final PursuitControl pursuit;

  /** Called by the launcher. */
  public DifferentialPursuitControl(ServiceContext context) {
    super(context, "Control");
    pursuit = new PursuitControl(this, settings());
    Motors.declare(this);
    getVariable(TRACK);
    getVariable(SPOT_TURN_FEEDBACK);
    getVariable(PursuitVariables.YAW_RATE_GAIN);
  }

  private PursuitSettings settings() {
    return PursuitVariables.settings(
        this,
        TIGHTEST,
        new PursuitSettings.SpotTurn(
            true,
            Math.toRadians(getVariable(SPOT_TURN_ABOVE)),
            Math.toRadians(Math.min(getVariable(SPOT_TURN_BELOW), getVariable(SPOT_TURN_ABOVE))),
            getVariable(SPOT_TURN_GAIN)));
  }

  /** Drives on with other gains and limits. */
  @Override
  protected void configurationChanged(Set<String> variableNames) {
    pursuit.settings(settings());
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<GroundTarget> target =
        ground.target(state, point, point.flatMap(this::stateOf), point.flatMap(this::nedOf));
    GroundControl.Measured measured = ground.measured(state, stepS());
    PursuitControl.Demand demand = pursuit.step(target, measured, stepS());
    pursuit
        .commanded(demand, drive(demand), measured, stepS())
        .ifPresent(
            words -> {
              trouble(words);
              balance.relax();
            });
  }

  /** Commands the motors; returns what they are asked for by what they can. */
  private double drive(PursuitControl.Demand demand) {
    DriveCalibration motor = pursuit.calibration();
    Drive drive = demand.drive();
    Drive told = new Drive(drive.speedMps() + demand.trimMps(), drive.yawRateRadPerS());
    WheelSpeeds wheels = WheelSpeeds.of(told, getVariable(TRACK), motor.maxMps());
    WheelShares shares =
        balance.step(
            new WheelShares(motor.share(wheels.leftMps()), motor.share(wheels.rightMps())),
            drive.speedMps() > 0.0 ? motor.share(told.speedMps()) : 0.0,
            demand.yawErrorRadPerS(),
            feedback(motor),
            stepS());
    WheelShares possible = shares.possible();
    commandShare(Motors.left(this), possible.left());
    commandShare(Motors.right(this), possible.right());
    return shares.effort();
  }

  private WheelBalance.Settings feedback(DriveCalibration motor) {
    return new WheelBalance.Settings(
        getVariable(PursuitVariables.YAW_RATE_GAIN),
        0.5 * getVariable(PursuitVariables.RESPONSE_TIME),
        getVariable(PursuitVariables.TURN_GAIN),
        getVariable(SPOT_TURN_FEEDBACK),
        getVariable(Motors.MISMATCH_LIMIT) / FULL_PERCENT,
        0.5 * getVariable(TRACK) * (1.0 - motor.startShare()) / motor.maxMps());
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    pursuit.handOver(state);
    balance.handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    balance.takeOver(state);
    pursuit.takeOver(state, isOfMyClass(state), lastDrive());
  }

  /** The motion that the motors were commanded last, by whatever control. */
  private Drive lastDrive() {
    DriveCalibration motor = pursuit.calibration();
    return new WheelSpeeds(
            motor.speedMps(lastShare(Motors.left(this))),
            motor.speedMps(lastShare(Motors.right(this))))
        .drive(getVariable(TRACK));
  }

  @Override
  protected Map<String, Double> neutral() {
    return Motors.neutral(this);
  }
}
