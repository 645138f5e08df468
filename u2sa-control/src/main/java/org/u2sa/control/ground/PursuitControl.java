package org.u2sa.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.control.Transfer;
import org.u2sa.service.handover.HandOver;

/**
 * Regulated pure pursuit independent of the drive: computes the motion command with feedback from
 * the measured motion, and rests stalled motors. Not thread-safe.
 */
final class PursuitControl {
  private static final double MIN_RESPONSE_S = 1.0e-3;

  private final Supplier<PursuitVariables> tuning;
  private final PursuitLaw law;
  private final SpeedTrim speedTrim = new SpeedTrim();
  private final InertiaFeedForward inertia = new InertiaFeedForward();
  private final MotionWatch watch = new MotionWatch();
  private Drive due = Drive.STANDING; // expected motion by now, after the response lag
  private boolean atFullPower;

  PursuitControl(Supplier<PursuitVariables> tuning, PursuitSettings settings) {
    this.tuning = tuning;
    law = new PursuitLaw(settings);
  }

  /** Replaces the gains and limits. */
  void settings(PursuitSettings settings) {
    law.settings(settings);
  }

  /**
   * Demand on the motors.
   *
   * @param drive motion command
   * @param moreMps addition for trim and inertia [m/s]
   * @param yawErrorRadPerS wanted minus measured yaw rate; empty if unknown
   */
  record Demand(Drive drive, double moreMps, OptionalDouble yawErrorRadPerS) {}

  /**
   * Continues from the motion left after the motors have been neutral for a time [s]. Otherwise the
   * vehicle would lurch, and feedback would take its standstill for a load.
   */
  void coasted(double seconds) {
    double left = Math.exp(-seconds / Math.max(MIN_RESPONSE_S, tuning.get().responseTime()));
    due = new Drive(left * due.speedMps(), left * due.yawRateRadPerS());
    law.startFrom(due);
    speedTrim.scale(left);
    inertia.startFrom(due.speedMps());
  }

  /** Computes the demand after a state. */
  Demand step(Optional<GroundTarget> target, GroundControl.Measured measured, double stepS) {
    Drive drive = law.step(watch.rests(measured, stepS) ? Optional.empty() : target, stepS);
    follow(drive, tuning.get().responseTime(), stepS);
    double trim =
        speedTrim.step(
            drive,
            error(due.speedMps(), measured.forwardMps()),
            atFullPower,
            tuning.get().speedGain(),
            tuning.get().maxSpeed(),
            stepS);
    double more = inertia.step(drive.speedMps(), tuning.get().pickUpTime(), stepS);
    double told = drive.isStanding() ? 0.0 : trim + more;
    return new Demand(drive, told, error(due.yawRateRadPerS(), measured.yawRateRadPerS()));
  }

  /**
   * Models the lag of motors, tyres and sensors as first order, so that feedback does not treat it
   * as an error.
   */
  private void follow(Drive demanded, double responseS, double stepS) {
    double share = stepS / (responseS + stepS);
    due =
        new Drive(
            due.speedMps() + share * (demanded.speedMps() - due.speedMps()),
            due.yawRateRadPerS() + share * (demanded.yawRateRadPerS() - due.yawRateRadPerS()));
  }

  private static OptionalDouble error(double wanted, OptionalDouble measured) {
    return measured.isPresent()
        ? OptionalDouble.of(wanted - measured.getAsDouble())
        : OptionalDouble.empty();
  }

  /**
   * Records this step's demand as a fraction of the motors' capability: more than 1 if saturated.
   *
   * @return warning for the user if the motors do not move the vehicle
   */
  Optional<String> commanded(
      Demand demand, double effort, GroundControl.Measured measured, double stepS) {
    atFullPower = effort > 1.0;
    return watch.see(
        demand.drive(),
        measured,
        effort,
        tuning.get().stallTime(),
        tuning.get().stallPause(),
        stepS);
  }

  void handOver(HandOver state) {
    law.transfer(Transfer.saving(state));
    speedTrim.transfer(Transfer.saving(state));
  }

  /**
   * Continues from another control system.
   *
   * @param alike whether the predecessor had the same class
   * @param last motion last commanded to the motors
   */
  void takeOver(HandOver state, boolean alike, Drive last) {
    if (alike) {
      law.transfer(Transfer.restoring(state));
      speedTrim.transfer(Transfer.restoring(state));
    } else {
      law.startFrom(last);
    }
  }
}
