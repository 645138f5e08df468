package org.u2sa.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.control.Transfer;

/**
 * Regulated pure pursuit: drives the arc to the point, slower in tight curves and near the goal,
 * within the vehicle's acceleration; turns in place toward a point well off to the side, if the
 * vehicle can.
 *
 * <p>After Macenski, Singh, Martin, Ginés: Regulated Pure Pursuit for Robot Path Tracking,
 * Autonomous Robots 47 (2023), sections 3.2 and 3.3, as in ROS 2's Nav2. Not thread-safe.
 */
final class PursuitLaw {
  /**
   * Hysteresis: stays stopped until the point is this many tolerances away, because positions are
   * noisy.
   */
  private static final double LEAVES_AFTER = 2.0;

  private static final double TURNED_RAD = Math.toRadians(1.0); // a turn at the target ends here

  private PursuitSettings settings;
  private Drive drive = Drive.STANDING;
  private double curvature; // of the arc to the target [1/m], left positive; 0 to stop
  private boolean turning;
  private boolean arrived;
  private boolean turned; // has turned to the required heading at the target

  PursuitLaw(PursuitSettings settings) {
    this.settings = settings;
  }

  /** Replaces the gains and limits. */
  void settings(PursuitSettings newSettings) {
    settings = newSettings;
  }

  /** Starts from the motion another law last commanded (bumpless transfer). */
  void startFrom(Drive moving) {
    drive = moving;
  }

  void transfer(Transfer state) {
    double speed = state.number("SPEED", drive.speedMps());
    drive = new Drive(speed, state.number("YAW RATE", drive.yawRateRadPerS()));
    turning = state.flag("TURNING", turning);
    arrived = state.flag("ARRIVED", arrived);
    turned = state.flag("TURNED", turned);
  }

  /**
   * Computes the motion command.
   *
   * @param target target, or empty to stop
   * @param stepS time since the previous call [s]
   */
  Drive step(Optional<GroundTarget> target, double stepS) {
    Drive wanted = target.map(this::towards).orElseGet(this::stand);
    double speed = speed(wanted.speedMps(), stepS);
    double yawRate = wanted.yawRateRadPerS();
    boolean byHand = target.flatMap(GroundTarget::byHand).isPresent();
    if (byHand && !settings.spotTurn().possible()) {
      yawRate = bounded(yawRate, Math.abs(speed) * settings.largestCurvature());
    } else if (!turning && !byHand) {
      yawRate = speed * curvature; // the arc, too, on which it brakes to a stop
    }
    drive =
        new Drive(
            speed,
            approach(
                drive.yawRateRadPerS(),
                bounded(yawRate, settings.tuning().turnRateRadPerS()),
                stepS * settings.tuning().turnAccelerationRadPerS2()));
    return drive;
  }

  /** Next speed towards the wanted one; the other way, it brakes to a stop first. */
  private double speed(double wantedMps, double stepS) {
    double before = drive.speedMps();
    boolean turnsBack = wantedMps * before < 0.0;
    boolean slower = turnsBack || Math.abs(wantedMps) < Math.abs(before);
    double rate = slower ? settings.tuning().braking() : settings.tuning().acceleration();
    return approach(before, turnsBack ? 0.0 : wantedMps, stepS * rate);
  }

  private Drive stand() {
    turning = false;
    curvature = 0.0;
    return Drive.STANDING;
  }

  private Drive towards(GroundTarget target) {
    if (target.byHand().isPresent()) {
      arrived = false;
      turning = false;
      return target.byHand().get();
    }
    arrived = target.distanceM() <= settings.tuning().tolerance() * (arrived ? LEAVES_AFTER : 1.0);
    PursuitSettings.SpotTurn spot = settings.spotTurn();
    if (arrived) {
      return spot.possible() ? turnedBy(target.turnRad()) : stand();
    }
    double bearing = target.bearingRad();
    turning =
        spot.possible()
            && !target.backwards()
            && Math.abs(bearing) > (turning ? spot.belowRad() : spot.aboveRad());
    if (turning) {
      return spotTurn(bearing);
    }
    curvature = curvature(target);
    double speed = speed(target);
    double along = target.backwards() ? -speed : speed; // same arc, in reverse
    return new Drive(along, along * curvature);
  }

  /** Turns in place and stops at that heading. */
  private Drive turnedBy(OptionalDouble turnRad) {
    double leftRad = turnRad.orElse(0.0);
    turned = Math.abs(leftRad) <= TURNED_RAD * (turned ? LEAVES_AFTER : 1.0);
    if (turned) {
      return stand();
    }
    turning = true;
    return spotTurn(leftRad);
  }

  private Drive spotTurn(double leftRad) {
    return new Drive(
        0.0, bounded(settings.spotTurn().gain() * leftRad, settings.tuning().turnRateRadPerS()));
  }

  /** Curvature of the arc through the point, tangent to the heading: 2 y / L² (eq. 2). */
  private double curvature(GroundTarget target) {
    double distance = target.distanceM();
    double ahead = target.backwards() ? -target.forwardM() : target.forwardM();
    if (ahead <= 0.0) { // point is behind: turn as tightly as possible
      return Math.copySign(settings.largestCurvature(), target.leftM());
    }
    return bounded(2.0 * target.leftM() / (distance * distance), settings.largestCurvature());
  }

  private double speed(GroundTarget target) {
    double cruise = target.speedMps().orElse(settings.tuning().cruiseSpeed());
    double tightness = Math.abs(curvature) * settings.tuning().regulatedRadius();
    double inCurve = tightness > 1.0 ? cruise / tightness : cruise; // eq. 5
    double nearGoal =
        cruise * Math.min(1.0, target.distanceM() / settings.tuning().approachDistance()); // eq. 7
    double wanted =
        Math.max(Math.min(inCurve, nearGoal), Math.min(settings.tuning().approachSpeed(), cruise));
    double steerable = settings.tuning().turnRateRadPerS() / Math.abs(curvature); // holds the arc
    return Math.min(wanted, steerable);
  }

  /** Moves from one value toward another by at most one step. */
  private static double approach(double from, double to, double step) {
    return from + bounded(to - from, step);
  }

  private static double bounded(double value, double bound) {
    return Math.max(-bound, Math.min(bound, value));
  }
}
