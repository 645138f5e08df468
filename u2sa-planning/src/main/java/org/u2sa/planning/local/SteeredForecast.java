package org.u2sa.planning.local;

import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.service.motion.Drift;

/**
 * Simulates steering a drifting boat to a point, to predict how close obstacles come: the boat
 * turns its bow to the point and against the drift, and thrusts in proportion to the alignment,
 * while wind and current carry it. Not thread-safe.
 */
final class SteeredForecast {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final double STEP_S = 0.2;
  private static final double LASTS_S = 7.0; // time to turn round and move one length
  private static final double ARRIVED_M = 0.8;
  private static final double TURNS_S = 0.8; // turn rate: the remaining angle over this time
  private static final double LAG_S = 0.3; // time constant of the turn rate

  private final CostGrid costs;
  private final BodyDiscs body;
  private final TrafficForecast traffic;
  private final MotionLimits limits;
  private final Pose start;
  private final double startMps; // through the water
  private final Drift drift;
  private final double requiredM; // nearer to an obstacle is a collision

  /**
   * Predicted outcome.
   *
   * @param isFree whether it keeps its distance from obstacles and traffic and, in reverse, stays
   *     over water that was seen or passed
   * @param touchesS time of the first collision [s]; infinite if none
   * @param leastM minimum distance to obstacles and traffic until then [m]
   * @param end pose at the end or on arrival
   */
  record Outcome(boolean isFree, double touchesS, double leastM, Pose end) {}

  /**
   * @param aheadMps velocity over ground along the bow [m/s]
   */
  SteeredForecast(
      CostGrid costs,
      BodyDiscs body,
      TrafficForecast traffic,
      MotionLimits limits,
      Pose start,
      double aheadMps,
      Drift drift) {
    this.costs = costs;
    this.body = body;
    this.traffic = traffic;
    this.limits = limits;
    this.start = start;
    this.drift = drift;
    startMps = aheadMps - drift.towardsMps(start.headingRad());
    requiredM = Math.min(limits.touchM(), clearanceM(start) - 1.0e-6);
  }

  /**
   * Simulates a choice. At its end the boat brakes, among traffic: it may have to stop there.
   *
   * @param speedMps speed over ground; 0: stops and drifts
   */
  Outcome to(double northM, double eastM, double speedMps, boolean backwards) {
    Pose at = start;
    double through = startMps;
    double rate = 0.0;
    double least = NEVER;
    boolean isFree = true;
    Pose end = null; // where it arrives
    int step = 0;
    for (double t = STEP_S; t <= LASTS_S; t += STEP_S) {
      step++;
      double bearing = Math.atan2(eastM - at.eastM(), northM - at.northM());
      double along = drift.towardsMps(at.headingRad());
      double turn = end == null ? Pose.wrapped(bearing - at.headingRad()) : 0.0;
      double ahead = (backwards ? -1.0 : 1.0) * Math.cos(turn);
      if (end == null) {
        turn += backwards ? Math.PI : drift.crabRad(bearing, Math.max(0.0, through + along));
      }
      double most = limits.turnRateRadPerS();
      double wanted = Math.max(-most, Math.min(most, Pose.wrapped(turn) / TURNS_S));
      rate += Math.min(1.0, STEP_S / LAG_S) * (wanted - rate);
      double mps = end == null ? speedMps : 0.0;
      double speed = (backwards ? -mps : mps) * Math.max(0.0, ahead);
      through += change(speed - along - through, through);
      double heading = at.headingRad() + rate * STEP_S;
      at =
          new Pose(
              at.northM() + STEP_S * (through * Math.cos(heading) + drift.northMps()),
              at.eastM() + STEP_S * (through * Math.sin(heading) + drift.eastMps()),
              heading);
      double clearance = end == null ? clearanceM(at) : NEVER;
      traffic.place(at);
      double gap = traffic.gapM(0.0, step, t);
      least = Math.min(least, Math.min(clearance, gap));
      if (clearance < requiredM || gap < 0.0) {
        return new Outcome(false, t, least, end == null ? at : end);
      }
      isFree = isFree && !traffic.meets(0.0, step, t) && !(backwards && isRearUnseen(at));
      if (end == null && speedMps > 0.0 && at.distanceM(northM, eastM) < ARRIVED_M) {
        end = at;
      }
      if (end != null && traffic.isEmpty()) {
        break;
      }
    }
    return new Outcome(isFree, NEVER, least, end == null ? at : end);
  }

  private double change(double wantedMps, double throughMps) {
    boolean isFaster = wantedMps * throughMps >= 0.0;
    double most = STEP_S * (isFaster ? limits.accelerationMps2() : limits.brakingMps2());
    return Math.max(-most, Math.min(most, wantedMps));
  }

  private boolean isRearUnseen(Pose at) {
    return body.isRearUnseen(costs, at.northM(), at.eastM(), at.headingRad());
  }

  private double clearanceM(Pose at) {
    double enough = costs.frame().cellM();
    return body.clearanceM(costs, at.northM(), at.eastM(), at.headingRad(), enough);
  }
}
