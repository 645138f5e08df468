package org.u2sa.control.ground;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Follows the navigation points of a ground vehicle with steered front wheels by regulated pure
 * pursuit. In: navigation, state. Out: actuation of throttle (forwards positive) and steering (to
 * the right positive), once per state. Without fresh navigation or without a position, the vehicle
 * brakes to a stop.
 */
public final class AckermannPursuitControl extends GroundControl {
  /** Steering settings. */
  private record Steering(
      @Variable(unit = "m", min = 0.05, max = 20, ifAbsent = 0.33)
          @Description("Distance between the front and rear axles.")
          double wheelbase,
      @Variable(unit = "deg", min = 1, max = 70, ifAbsent = 24)
          @Description(
              "Mean angle of the front wheels at 100 %; with WHEELBASE it sets the tightest curve.")
          double steeringAngle,
      @Variable(ifAbsentText = "THROTTLE") @Description("Drive actuator, forward positive.")
          String throttleActuator,
      @Variable(ifAbsentText = "STEERING") @Description("Steering actuator, right positive.")
          String steeringActuator,
      @Variable(ifAbsentText = "PURSUIT")
          @Description(
              "PURSUIT steers to the navigation point, STANLEY along the path that navigation points describe.")
          SteeringLaw steeringLaw,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the steering is commanded as an angle instead of a percentage; its actuator must announce that it accepts angles.")
          boolean steersByAngle) {
    double angleRad() {
      return Math.toRadians(steeringAngle);
    }

    /** Curvature at full steering [1/m]. */
    double tightest() {
      return Math.tan(angleRad()) / wheelbase;
    }
  }

  /** Steering of the front wheels. */
  private enum SteeringLaw {
    PURSUIT,
    STANLEY
  }

  private static final double FULL_PERCENT = 100.0;
  private static final double SLOWEST_MPS = 0.1; // below this the steering is held

  private double misalignment; // learnt steering offset as curvature [1/m]; held at standstill

  private final Settings<PursuitVariables> tuning = settings(PursuitVariables.class);
  private final Settings<Steering> steering = settings(Steering.class);
  private final Settings<StanleyLaw.Variables> stanley = settings(StanleyLaw.Variables.class);
  private final PathSteering path = new PathSteering();
  private final PursuitControl pursuit = new PursuitControl(tuning, pursuitSettings());

  public AckermannPursuitControl(ServiceContext context) {
    super(context);
  }

  private PursuitSettings pursuitSettings() {
    return new PursuitSettings(
        tuning.get(), steering.get().tightest(), PursuitSettings.SpotTurn.NONE);
  }

  /** Applies new gains and limits while driving. */
  @Override
  protected void configurationChanged(Set<String> variableNames) {
    pursuit.settings(pursuitSettings());
  }

  @Override
  List<String> motors() {
    return List.of(steering.get().throttleActuator(), steering.get().steeringActuator());
  }

  /** Only Stanley's law needs a position, because it follows a path, not a point. */
  @Override
  protected boolean obeysWithoutState() {
    return steering.get().steeringLaw() != SteeringLaw.STANLEY;
  }

  @Override
  void coasted(double seconds) {
    pursuit.coasted(seconds);
  }

  @Override
  void drive(StateInformation state, Optional<GroundTarget> target, Measured measured) {
    PursuitControl.Demand demand = pursuit.step(target, measured, stepS());
    OptionalDouble alongPath =
        steering.get().steeringLaw() == SteeringLaw.STANLEY
            ? path.steeringRad(
                stanley.get(),
                state,
                target.filter(each -> each.byHand().isEmpty()),
                steering.get().wheelbase(),
                measured)
            : OptionalDouble.empty();
    pursuit.commanded(demand, drive(demand, alongPath), measured, stepS()).ifPresent(this::unmoved);
  }

  /**
   * Commands the motors; returns the demand as a fraction of the drive's capability.
   *
   * @param alongPath angle of the front wheels, left positive [rad]; if empty, derived from the
   *     demand
   */
  private double drive(PursuitControl.Demand demand, OptionalDouble alongPath) {
    Drive drive = demand.drive();
    Steering now = steering.get();
    double share = lastShare(now.steeringActuator());
    if (drive.speedMps() > SLOWEST_MPS && alongPath.isPresent()) {
      share = -alongPath.getAsDouble() / now.angleRad();
      share = Math.max(-1.0, Math.min(1.0, share));
    } else if (Math.abs(drive.speedMps()) > SLOWEST_MPS) {
      double wanted = drive.yawRateRadPerS() / drive.speedMps();
      if (demand.yawErrorRadPerS().isPresent()) {
        learn(demand.yawErrorRadPerS().getAsDouble() / drive.speedMps(), wanted);
      }
      double curvature = wanted + misalignment;
      // tan δ = L / R, a bicycle without slip (Rajamani: Vehicle Dynamics and Control, eq. 2.10)
      share = -Math.atan(now.wheelbase() * curvature) / now.angleRad();
    }
    double throttle = tuning.get().calibration().share(drive.speedMps() + demand.moreMps());
    commandShare(now.throttleActuator(), throttle);
    if (now.steersByAngle()) {
      double bounded = Math.max(-1.0, Math.min(1.0, share));
      double angle = bounded * now.angleRad();
      command(AngleCommand.of(now.steeringActuator(), angle), FULL_PERCENT * bounded);
    } else {
      commandShare(now.steeringActuator(), share);
    }
    return Math.abs(throttle);
  }

  /**
   * Learns the misalignment from an error of the curvature [1/m], but not from one that the wheels
   * at full lock cannot correct (anti-windup): afterwards it would turn the vehicle off its way.
   */
  private void learn(double error, double wanted) {
    double tightest = steering.get().tightest();
    double more = tuning.get().turnGain() * stepS() * error;
    double steered = wanted + misalignment;
    boolean isAtLock = Math.abs(steered) >= tightest && Math.signum(more) == Math.signum(steered);
    if (!isAtLock) {
      misalignment = Math.max(-tightest, Math.min(tightest, misalignment + more));
    }
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    pursuit.handOver(state);
    state.number("MISALIGNMENT", misalignment);
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    misalignment = state.number("MISALIGNMENT").orElse(0.0);
    if (isSwap()) {
      pursuit.takeOver(state, isOfMyClass(state), lastDrive());
    }
  }

  /** Motion last commanded to the motors, by any control system. */
  private Drive lastDrive() {
    Steering now = steering.get();
    double speed = tuning.get().calibration().speedMps(lastShare(now.throttleActuator()));
    double angle = -now.angleRad() * lastShare(now.steeringActuator());
    return new Drive(speed, speed * Math.tan(angle) / now.wheelbase());
  }
}
