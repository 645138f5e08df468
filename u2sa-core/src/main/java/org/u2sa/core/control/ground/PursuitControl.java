package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.service.HandOver;

/**
 * Regulated pure pursuit, for whatever motors the vehicle has: says how to move, with feedback from
 * how it moved, and rests motors that are too weak. Belongs to one thread.
 */
final class PursuitControl {
  private final Supplier<PursuitTuning> tuning;
  private final PursuitLaw law;
  private final TurnTrim speedTrim = new TurnTrim("SPEED TRIM");
  private final PickUp pickUp = new PickUp();
  private final MotionWatch watch = new MotionWatch();
  private Drive due = Drive.STANDING; // what the demanded motion should have become by now
  private boolean atFullPower;

  PursuitControl(Supplier<PursuitTuning> tuning, PursuitSettings settings) {
    this.tuning = tuning;
    law = new PursuitLaw(settings);
  }

  /** Drives on with other gains and limits. */
  void settings(PursuitSettings settings) {
    law.settings(settings);
  }

  /**
   * What the motors are to do.
   *
   * @param drive how the vehicle is to move
   * @param moreMps what must be told more, for that speed and for its change [m/s]
   * @param yawErrorRadPerS wanted yaw rate less the measured one; empty if unknown
   */
  record Demand(Drive drive, double moreMps, OptionalDouble yawErrorRadPerS) {}

  /** How to move now, after a state. */
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
    double more = pickUp.step(drive.speedMps(), tuning.get().pickUpTime(), stepS);
    double told = drive.isStanding() ? 0.0 : trim + more;
    return new Demand(drive, told, error(due.yawRateRadPerS(), measured.yawRateRadPerS()));
  }

  /**
   * Motors, tyres and sensors take their time, and feedback must not take that for an error. First
   * order.
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
   * Takes note of what the motors were asked for in that step, by what they can: more than 1 if
   * they cannot.
   *
   * @return what to tell the user if they do not move the vehicle
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
    law.handOver(state);
    speedTrim.handOver(state);
  }

  /**
   * Goes on from another control.
   *
   * @param alike whether it was of the same class
   * @param last the motion that the motors were commanded last
   */
  void takeOver(HandOver state, boolean alike, Drive last) {
    if (alike) {
      law.takeOver(state);
      speedTrim.takeOver(state);
    } else {
      law.startFrom(last);
    }
  }
}
