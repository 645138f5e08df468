package org.u2sa.core.control.ground;

import java.util.Optional;
import org.u2sa.service.HandOver;

/**
 * Regulated pure pursuit: drives the arc that leads to the point, slower in tight curves and near
 * the goal, with a speed that changes no faster than the vehicle can; turns on the spot towards a
 * point that lies far aside, where the vehicle can.
 *
 * <p>After Macenski, Singh, Martin, Ginés: Regulated Pure Pursuit for Robot Path Tracking,
 * Autonomous Robots 47 (2023), sections 3.2 and 3.3, as ROS 2's Nav2 has it. Belongs to one thread.
 */
final class PursuitLaw {
  /** It stands until the point is so many tolerances away again: positions scatter. */
  private static final double LEAVES_AFTER = 2.0;

  private PursuitSettings settings;
  private Drive drive = Drive.STANDING;
  private boolean turning;
  private boolean arrived;

  PursuitLaw(PursuitSettings settings) {
    this.settings = settings;
  }

  /** Goes on with other gains and limits. */
  void settings(PursuitSettings newSettings) {
    settings = newSettings;
  }

  /** Goes on from a motion that another law commanded. */
  void startFrom(Drive moving) {
    drive = moving;
  }

  void handOver(HandOver state) {
    state
        .number("SPEED", drive.speedMps())
        .number("YAW RATE", drive.yawRateRadPerS())
        .flag("TURNING", turning)
        .flag("ARRIVED", arrived);
  }

  void takeOver(HandOver state) {
    drive = new Drive(state.number("SPEED").orElse(0.0), state.number("YAW RATE").orElse(0.0));
    turning = state.flag("TURNING");
    arrived = state.flag("ARRIVED");
  }

  /**
   * How to move now.
   *
   * @param target where to go; empty: stop and stand
   * @param stepS since the call before [s]
   */
  Drive step(Optional<GroundTarget> target, double stepS) {
    Drive wanted = target.map(this::towards).orElseGet(this::stand);
    boolean slower = Math.abs(wanted.speedMps()) < Math.abs(drive.speedMps());
    double speed =
        approach(
            drive.speedMps(),
            wanted.speedMps(),
            stepS * (slower ? settings.tuning().braking() : settings.tuning().acceleration()));
    double yawRate = wanted.yawRateRadPerS();
    if (!turning && wanted.speedMps() != 0.0) {
      yawRate *= speed / wanted.speedMps(); // the same arc at the speed that it has
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

  private Drive stand() {
    turning = false;
    return Drive.STANDING;
  }

  private Drive towards(GroundTarget target) {
    arrived = target.distanceM() <= settings.tuning().tolerance() * (arrived ? LEAVES_AFTER : 1.0);
    if (arrived) {
      return stand();
    }
    PursuitSettings.SpotTurn spot = settings.spotTurn();
    double bearing = target.bearingRad();
    turning =
        spot.possible()
            && !target.backwards()
            && Math.abs(bearing) > (turning ? spot.belowRad() : spot.aboveRad());
    if (turning) {
      return new Drive(0.0, bounded(spot.gain() * bearing, settings.tuning().turnRateRadPerS()));
    }
    double curvature = curvature(target);
    double speed = speed(target, curvature);
    double along = target.backwards() ? -speed : speed; // the same arc, the rear first
    return new Drive(along, along * curvature);
  }

  /** Of the arc through the point, tangent to the vehicle's heading: 2 y / L² (eq. 2). */
  private double curvature(GroundTarget target) {
    double distance = target.distanceM();
    double ahead = target.backwards() ? -target.forwardM() : target.forwardM();
    if (ahead <= 0.0) { // the arc would begin the other way: as tight as can be
      return Math.copySign(settings.largestCurvature(), target.leftM());
    }
    return bounded(2.0 * target.leftM() / (distance * distance), settings.largestCurvature());
  }

  private double speed(GroundTarget target, double curvature) {
    double cruise = target.speedMps().orElse(settings.tuning().cruiseSpeed());
    double tightness = Math.abs(curvature) * settings.tuning().regulatedRadius();
    double inCurve = tightness > 1.0 ? cruise / tightness : cruise; // eq. 5
    double nearGoal =
        cruise * Math.min(1.0, target.distanceM() / settings.tuning().approachDistance()); // eq. 7
    double wanted =
        Math.max(Math.min(inCurve, nearGoal), Math.min(settings.tuning().approachSpeed(), cruise));
    double steerable =
        settings.tuning().turnRateRadPerS() / Math.abs(curvature); // on the arc, not outside
    return Math.min(wanted, steerable);
  }

  /** From one value towards another, by at most a step. */
  private static double approach(double from, double to, double step) {
    return from + bounded(to - from, step);
  }

  private static double bounded(double value, double bound) {
    return Math.max(-bound, Math.min(bound, value));
  }
}
