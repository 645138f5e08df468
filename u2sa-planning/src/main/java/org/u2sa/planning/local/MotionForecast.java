package org.u2sa.planning.local;

import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;

/**
 * Simulates motions to find how far they are free of static obstacles, and when they meet traffic.
 * A vehicle that can stop is assumed to stop before obstacles, and is also checked while stopped.
 * Not thread-safe.
 */
final class MotionForecast {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final double STANDS_MPS = 1.0e-3;
  private static final int STOPPING_ARCS = 5; // to each side
  private static final double ROLLS_CELLS = 0.5; // a shorter way to a stop is that of a noisy speed

  private final CostGrid costs;
  private final BodyDiscs body;
  private final TrafficForecast traffic;
  private final VerticalRoom room; // null: does not climb to evade
  private final MotionLimits limits;
  private final Pose start;
  private final double startMps;
  private final double requiredM; // closer to a static obstacle is a collision
  private final double inside; // share of the body's discs on obstacles at the start
  private final double enoughM; // greater distances are not distinguished
  private final double stepS;

  /**
   * Predicted outcome of a motion.
   *
   * @param freeM distance to the first static obstacle [m]; infinite if none
   * @param meetsS time until traffic is too close [s]; infinite within the horizon
   * @param gapM minimum distance to traffic within the horizon [m]; infinite without traffic
   * @param nearestS time of that minimum [s]; 0 without traffic
   * @param roomM mean distance to traffic in that time, up to {@link TrafficForecast#ROOMY_M} [m]
   * @param lacksM shortfall of the preferred distance to static obstacles: RMS along the path [m]
   * @param seenM in reverse, distance to the first ground that was neither seen nor passed [m];
   *     infinite if none
   */
  record Outcome(
      double freeM,
      double meetsS,
      double gapM,
      double nearestS,
      double roomM,
      double lacksM,
      double seenM) {
    /** Distance to the first static obstacle or, in reverse, unseen ground [m]. */
    double freeAndSeenM() {
      return Math.min(freeM, seenM);
    }
  }

  MotionForecast(
      CostGrid costs,
      BodyDiscs body,
      TrafficForecast traffic,
      VerticalRoom room,
      MotionLimits limits,
      Pose start,
      double startMps) {
    this.costs = costs;
    this.body = body;
    this.traffic = traffic;
    this.room = room;
    this.limits = limits;
    this.start = start;
    this.startMps = startMps;
    enoughM = Math.max(costs.frame().cellM(), limits.preferredM());
    requiredM = Math.min(limits.touchM(), clearanceM(start) - 1.0e-6);
    inside = requiredM < 0.0 ? inside(start) : 0.0;
    stepS = Math.max(0.02, 0.7 * costs.frame().cellM() / Math.max(0.1, limits.speedMps()));
  }

  /** Current distance to traffic [m]; negative inside the clearance to be kept. */
  double gapNowM() {
    traffic.place(start);
    return traffic.gapM(room == null ? 0.0 : room.downM(), 0, 0.0);
  }

  /** Down coordinate of the vehicle on its way to an altitude, or to that of the goal [m]. */
  private double downM(Pose at, double toDownM, double seconds) {
    if (room == null) {
      return 0.0;
    }
    double changesS = seconds - limits.reactionS();
    return Double.isNaN(toDownM) ? room.onWayM(at, changesS) : room.afterM(toDownM, changesS);
  }

  /**
   * Simulates braking from the current pose.
   *
   * @param toDownM altitude to which it climbs or descends [m]; NaN: that of the goal
   */
  Outcome standing(double toDownM) {
    Tally tally = new Tally();
    double v = Math.abs(startMps);
    Pose at = start;
    for (double t = 0.0; t <= limits.horizonS(); t += stepS) {
      if (t > limits.reactionS()) {
        v = Math.max(0.0, v - limits.brakingMps2() * stepS);
      }
      at = at.along(Math.copySign(v * stepS, startMps), 0.0);
      double down = downM(at, toDownM, t);
      tally.look(at, down, t);
      if (!Double.isNaN(toDownM) && room != null && room.isBlocked(at, down)) {
        return tally.outcome(0.0);
      }
    }
    return tally.outcome(NEVER);
  }

  /**
   * Curvature on which it keeps away from static obstacles while it stops [1/m], right positive:
   * straight if that is possible, otherwise the least that is, or that on which it stays farthest.
   */
  double stoppingCurvature() {
    double bestCurvature = 0.0;
    double mostM = -NEVER;
    for (int side = 0; side <= 2 * STOPPING_ARCS; side++) {
      int k = (side % 2 == 0 ? 1 : -1) * ((side + 1) / 2); // straight first
      double curvature = limits.tightest() * k / STOPPING_ARCS;
      double leastM = stoppingClearanceM(curvature);
      if (leastM >= requiredM) {
        return curvature;
      }
      if (leastM > mostM) {
        mostM = leastM;
        bestCurvature = curvature;
      }
    }
    return bestCurvature;
  }

  /** Minimum clearance to static obstacles on the way to a stop [m]. */
  private double stoppingClearanceM(double curvature) {
    double wayM = limits.stoppingM(Math.abs(startMps));
    double leastM = NEVER;
    for (double gone = costs.frame().cellM(); gone < wayM; gone += costs.frame().cellM()) {
      Pose at = start.along(Math.copySign(gone, startMps), curvature);
      leastM = Math.min(leastM, clearanceM(at));
    }
    return leastM;
  }

  /** Mean distance of the vehicle to static obstacles along an arc of some length [m]. */
  double roomM(double curvature, boolean backwards, double wayM) {
    double step = costs.frame().cellM();
    double sum = 0.0;
    int count = 0;
    for (double gone = step; gone <= wayM; gone += step) {
      Pose at = start.along(backwards ? -gone : gone, curvature);
      sum += body.meanDistanceM(costs, at.northM(), at.eastM(), at.headingRad());
      count++;
    }
    return count == 0 ? 0.0 : sum / count;
  }

  Outcome play(Motion motion) {
    if (!limits.stops()) {
      return play(motion, NEVER, true);
    }
    Outcome alone = play(motion, NEVER, false);
    if (traffic.isEmpty()) {
      return alone;
    }
    double stopM = Math.max(0.0, Math.min(motion.endM(), alone.freeM() - costs.frame().cellM()));
    Outcome among = play(motion, stopM, true);
    return new Outcome(
        alone.freeM(),
        among.meetsS(),
        among.gapM(),
        among.nearestS(),
        among.roomM(),
        alone.lacksM(),
        alone.seenM());
  }

  /**
   * @param stopM distance at which it stops [m]; infinite if it does not stop
   * @param amongTraffic whether to check traffic up to the horizon, or only static obstacles; these
   *     are also checked up to the horizon if there is traffic
   */
  private Outcome play(Motion motion, double stopM, boolean amongTraffic) {
    double sign = motion.sign();
    double farM = Math.max(motion.arcM(), farM(motion));
    boolean looks = amongTraffic && !traffic.isEmpty();
    // the stopping point determines where traffic meets it
    boolean toHorizon = limits.stops() && !amongTraffic && !traffic.isEmpty();
    Tally tally = new Tally();
    double v = motion.turnRad() == 0.0 ? Math.max(0.0, sign * startMps) : 0.0;
    double rolls =
        motion.turnRad() == 0.0 ? rollsOnMps(motion) : startMps; // before a turn in place
    double rollCurvature = motion.turnRad() == 0.0 ? motion.curvature() : 0.0;
    double turned = 0.0;
    double gone = 0.0;
    double freeM = NEVER;
    double arcMps = motion.speedMps() * (motion.track() == null ? 1.0 : turning(motion));
    Pose at = start;
    for (double t = 0.0; t <= limits.horizonS() || gone < farM; t += stepS) {
      double step = 0.0;
      if (rolls != 0.0) {
        rolls = slower(rolls, t);
        at = at.along(rolls * stepS, rollCurvature);
      } else if (turned < Math.abs(motion.turnRad())) {
        turned += limits.turnRateRadPerS() * stepS;
        double share = Math.min(turned, Math.abs(motion.turnRad()));
        at =
            new Pose(
                at.northM(),
                at.eastM(),
                start.headingRad() + Math.copySign(share, motion.turnRad()));
      } else {
        double wanted = gone < motion.arcM() ? arcMps : motion.speedMps();
        if (stopM < NEVER) {
          double left = Math.max(0.0, stopM - gone);
          wanted = Math.min(wanted, Math.sqrt(2.0 * limits.brakingMps2() * left));
        }
        double change = wanted > v ? limits.accelerationMps2() : limits.brakingMps2();
        v += Math.max(-change * stepS, Math.min(change * stepS, wanted - v));
        step = v * stepS;
        gone += step;
        at = next(at, step, gone, motion);
      }
      boolean within = freeM == NEVER && stopM == NEVER && (toHorizon || gone <= farM + step);
      if (within) {
        double clearance = clearanceM(at);
        if (limits.preferredM() > 0.0) {
          tally.keep(limits.preferredM() - clearance, step);
        }
        if (motion.backwards() && tally.seenM == NEVER && isRearUnseen(at)) {
          tally.seenM = Math.max(0.0, gone - step);
        }
        if (clearance < requiredM || inside > 0.0 && inside(at) > inside) {
          freeM = Math.max(0.0, gone - step);
        }
      }
      if (freeM == NEVER && isBlockedElsewhere(at, downM(at, motion.toDownM(), t), motion, gone)) {
        freeM = Math.max(0.0, gone - step);
      }
      if (looks && t <= limits.horizonS()) {
        tally.look(at, downM(at, motion.toDownM(), t), t);
      }
      boolean seenAll = gone >= farM && !looks && !toHorizon;
      if (seenAll || freeM < NEVER || (v < STANDS_MPS && t > limits.horizonS())) {
        break;
      }
    }
    return tally.outcome(freeM);
  }

  /** Speed of a vehicle that has to stop first, because the motion leads the other way [m/s]. */
  private double rollsOnMps(Motion motion) {
    boolean turnsBack = motion.sign() * startMps < 0.0;
    double wayM = limits.stoppingM(Math.abs(startMps));
    return turnsBack && wayM > ROLLS_CELLS * costs.frame().cellM() ? startMps : 0.0;
  }

  /** Factor on the speed in an arc: if it turns in place, its outer side is not faster. */
  private double turning(Motion motion) {
    double across = Math.abs(motion.curvature()) * body.radiusM();
    return limits.turnsOnTheSpot() ? 1.0 / (1.0 + across) : 1.0;
  }

  private double slower(double mps, double t) {
    if (t <= limits.reactionS()) {
      return mps;
    }
    double left = Math.abs(mps) - limits.brakingMps2() * stepS;
    return left <= 0.0 ? 0.0 : Math.copySign(left, mps);
  }

  /** Range of the check for static obstacles beyond the arc [m]. */
  private double farM(Motion motion) {
    if (limits.stops()) {
      double v = Math.max(0.0, motion.sign() * startMps);
      double stopping =
          limits.stoppingM(Math.max(v, motion.speedMps())) + 2.0 * costs.frame().cellM();
      // equally far along each arc, so that clearances are comparable
      return limits.preferredM() > 0.0 ? Math.max(limits.lookAheadM(), stopping) : stopping;
    }
    // on its route, as far as it needs to turn back
    return motion.track() == null
        ? 0.0
        : Math.min(4.0 * limits.turnRadiusM(), motion.track().remainingM());
  }

  private Pose next(Pose at, double step, double gone, Motion motion) {
    double sign = motion.sign();
    RouteTrack track = motion.track();
    if (gone <= motion.arcM() || track == null) {
      return at.along(sign * step, gone <= motion.arcM() ? motion.curvature() : 0.0);
    }
    if (!limits.stops()) { // off its route it must fly back, past obstacles on the way
      double ahead = gone + limits.lookAheadM();
      return at.along(
          step, limits.curvatureTo(at, track.northAheadM(ahead), track.eastAheadM(ahead), false));
    }
    double north = track.northAheadM(gone);
    double east = track.eastAheadM(gone);
    double heading = Math.atan2(sign * (east - at.eastM()), sign * (north - at.northM()));
    boolean stays = Math.hypot(east - at.eastM(), north - at.northM()) < 1.0e-6;
    return new Pose(north, east, stays ? at.headingRad() : heading);
  }

  /** Whether a vehicle that cannot stop can circle to either side at the end of an arc. */
  boolean canCircleAfter(Motion motion) {
    Pose from = start.along(motion.sign() * motion.arcM(), motion.curvature());
    double downM = downM(from, motion.toDownM(), motion.arcM() / motion.speedMps());
    double radius = 1.1 * limits.turnRadiusM();
    double step = Math.max(costs.frame().cellM(), 0.1 * radius);
    for (int side = -1; side <= 1; side += 2) {
      boolean free = true;
      for (double gone = 0.0; gone < 2.0 * Math.PI * radius && free; gone += step) {
        Pose at = from.along(gone, side / radius);
        boolean isLow = room != null && room.isGroundNear(at, downM);
        free = clearanceM(at) >= limits.touchM() && !isLow;
      }
      if (free) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a climb or descent leads to obstacles at other altitudes, or a level motion to rising
   * ground. A vehicle that cannot stop may turn away from the ground after an arc, and is led along
   * its route by the mission.
   */
  private boolean isBlockedElsewhere(Pose at, double downM, Motion motion, double gone) {
    if (room == null) {
      return false;
    }
    if (!Double.isNaN(motion.toDownM())) {
      return room.isBlocked(at, downM);
    }
    boolean matters = limits.stops() || motion.track() == null && gone <= motion.arcM();
    return matters && room.isGroundNear(at, downM);
  }

  private double inside(Pose at) {
    return body.shareInside(costs, at.northM(), at.eastM(), at.headingRad());
  }

  private boolean isRearUnseen(Pose at) {
    return body.isRearUnseen(costs, at.northM(), at.eastM(), at.headingRad());
  }

  private double clearanceM(Pose at) {
    return body.clearanceM(costs, at.northM(), at.eastM(), at.headingRad(), enoughM);
  }

  /** Traffic statistics of a simulated motion. */
  private final class Tally {
    private double meetsS = NEVER;
    private double gapM = NEVER;
    private double nearestS;
    private double roomM;
    private int looks; // one for each step
    private double seenM = NEVER;
    private double lacked; // squared shortfall integrated along the path [m³]
    private double way;

    void keep(double missingM, double step) {
      lacked += Math.max(0.0, missingM) * Math.max(0.0, missingM) * step;
      way += step;
    }

    void look(Pose at, double downM, double seconds) {
      traffic.place(at);
      double gap = traffic.gapM(downM, looks, seconds);
      if (gap < gapM) {
        gapM = gap;
        nearestS = seconds;
      }
      roomM += Math.min(TrafficForecast.ROOMY_M, gap);
      if (meetsS == NEVER && traffic.meets(downM, looks, seconds)) {
        meetsS = seconds;
      }
      looks++;
    }

    Outcome outcome(double freeM) {
      double room = looks == 0 ? TrafficForecast.ROOMY_M : roomM / looks;
      double lacksM = way == 0.0 ? 0.0 : Math.sqrt(lacked / way);
      return new Outcome(freeM, meetsS, gapM, nearestS, room, lacksM, seenM);
    }
  }
}
