package org.u2sa.planning.local;

import java.util.Optional;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.MotionForecast.Outcome;

/**
 * Chooses among evasive motions off the route: arcs to both sides, forward and reverse, at several
 * speeds, and turns in place; tried after motions along the route at another altitude, and before
 * arcs there (Fox, Burgard, Thrun: The Dynamic Window Approach to Collision Avoidance, IEEE
 * Robotics and Automation Magazine 4, 1997, with arcs instead of velocities, which are equivalent
 * at a given speed). Not thread-safe.
 */
final class Evasion {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int FAN = 10; // arcs to each side
  private static final int DIRECTIONS = 24; // number of directions for turns in place
  private static final double[] SPEEDS = {1.0, 0.6, 0.3};
  private static final double[] ENDS = {NEVER, 1.0, 0.5}; // stopping points, in reaches
  private static final double DEAD_END = 10.0; // cost of a motion without escape, in reaches
  private static final double OTHER_SIDE = 0.3; // cost of turning to the other side, in reaches
  private static final double ASIDE_RAD = Math.toRadians(10.0);
  private static final double SAME_M = 0.02; // smaller differences of gaps to traffic are ignored
  private static final double CLEARLY_M =
      1.0; // difference of gaps that justifies a climb or descent
  private static final double CLEARLY_S = 0.5; // likewise of the times of closest approach

  private final MotionForecast forecast;
  private final MotionLimits limits;
  private final VerticalRoom room; // null: does not climb to evade
  private final boolean amongTraffic;
  private final double side; // current turn: 1 right, -1 left, 0 neither
  private final Pose pose;
  private final double keptM; // clearance to static obstacles ahead
  private final double reachM;
  private double goalNorthM;
  private double goalEastM;
  private Motion onRoute; // free of static obstacles but too close to traffic

  private ArcChoice best;
  private Motion bestMotion; // null: at rest
  private double leastScore = NEVER;
  private ArcChoice widest; // best choice too close to traffic
  private double widestM = -NEVER;
  private double widestRoomM;
  private ArcChoice freest; // best choice blocked by static obstacles
  private double freestM = -1.0;

  Evasion(
      MotionForecast forecast,
      MotionLimits limits,
      VerticalRoom room,
      boolean amongTraffic,
      Optional<ArcChoice> before,
      Pose pose,
      double speedMps,
      double keptM) {
    this.forecast = forecast;
    this.limits = limits;
    this.room = room;
    this.amongTraffic = amongTraffic;
    side = limits.stops() ? 0.0 : before.map(choice -> side(choice, pose)).orElse(0.0);
    this.pose = pose;
    this.keptM = keptM;
    reachM = Math.max(limits.lookAheadM(), 1.2 * limits.stoppingM(Math.abs(speedMps)));
  }

  /**
   * Side of an evasive motion. An aircraft that keeps alternating between two equally good ones
   * flies straight on until neither is possible.
   */
  private static double side(ArcChoice before, Pose pose) {
    boolean evades = before.kind() == ArcChoice.Kind.EVADE || before.kind() == ArcChoice.Kind.BRAKE;
    double bearing = Math.atan2(before.eastM() - pose.eastM(), before.northM() - pose.northM());
    double aside = Pose.wrapped(bearing - pose.headingRad());
    return evades && Math.abs(aside) > ASIDE_RAD ? Math.signum(aside) : 0.0;
  }

  /** Adds a choice on the route that is free but too close to traffic. */
  void alsoConsider(ArcChoice choice, Motion motion, Outcome outcome) {
    onRoute = onRoute == null ? motion : onRoute;
    consider(choice, outcome);
  }

  /**
   * Chooses the best motion toward a position, or waiting; otherwise the motion that stays farthest
   * from obstacles.
   */
  ArcChoice choose(double northM, double eastM, ArcChoice stand) {
    goalNorthM = northM;
    goalEastM = eastM;
    double now = pose.distanceM(goalNorthM, goalEastM);
    boolean mayClimb = amongTraffic && room != null;
    if (mayClimb && onRoute != null) {
      stayOnRoute();
    }
    if (best != null) {
      return best;
    }
    arcs(Double.NaN);
    if (amongTraffic && limits.turnsOnTheSpot()) {
      turns();
    }
    Outcome standing = limits.stops() ? forecast.standing(Double.NaN) : null;
    boolean waits = standing != null && standing.meetsS() >= limits.horizonS();
    if (mayClimb && isTrapped() && !waits) {
      climb(stand);
    } else if (mayClimb && !limits.stops()) {
      best = best.at(apart());
    }
    if (best != null && (!waits || leastScore < 1.2 * now)) {
      return best;
    }
    if (waits) {
      return stand;
    }
    return lastResort(standing, stand);
  }

  /** Stays at its altitude, climbs or descends on its route. */
  private void stayOnRoute() {
    for (double downM : room.altitudes(limits.horizonS())) {
      weigh(onRoute.at(downM), 0.0);
      if (best != null) {
        return;
      }
    }
  }

  /** Stays at its altitude, or climbs or descends on an arc or in place. */
  private void climb(ArcChoice stand) {
    for (double downM : room.altitudes(limits.horizonS())) {
      if (limits.stops()) {
        Outcome there = forecast.standing(downM);
        if (there.freeM() == NEVER && there.meetsS() >= limits.horizonS()) {
          best = stand.as(ArcChoice.Kind.EVADE).at(downM);
          leastScore = 0.0;
        }
      }
      if (isTrapped()) {
        arcs(downM);
      }
      if (!isTrapped()) {
        return;
      }
    }
  }

  /**
   * Vertical way in place, down [m]: the wanted one if it keeps away from traffic for the horizon,
   * otherwise none, up or down, whichever keeps away longest.
   */
  double inPlaceM(double wantedM) {
    if (forecast.standing(Double.NaN).meetsS() >= limits.horizonS()) {
      return wantedM;
    }
    if (room == null) {
      return 0.0;
    }
    double bestM = 0.0;
    Outcome longest = forecast.standing(room.downM());
    for (double downM : room.altitudes(limits.horizonS())) {
      Outcome there = forecast.standing(downM);
      if (there.freeM() == NEVER && keepsAwayLonger(there, longest)) {
        longest = there;
        bestM = downM - room.downM();
      }
    }
    return bestM;
  }

  /**
   * Whether traffic comes too close later than in another motion. Inside the clearance, all motions
   * are too close before the vehicle can react: then it must clearly stay farther away or, if the
   * traffic passes equally close, be passed clearly later.
   */
  private boolean keepsAwayLonger(Outcome there, Outcome other) {
    if (Math.max(there.meetsS(), other.meetsS()) > limits.reactionS()) {
      return other.meetsS() < limits.horizonS() && there.meetsS() > other.meetsS();
    }
    double fartherM = there.gapM() - other.gapM();
    return Math.abs(fartherM) > CLEARLY_M
        ? fartherM > 0.0
        : there.nearestS() > other.nearestS() + CLEARLY_S;
  }

  /**
   * Altitude, above or below, at which the best motion also keeps its distance: a vehicle that
   * cannot stop and turns away from an equally fast aircraft at the same altitude ends at the
   * boundary. NaN if there is none: the goal's altitude.
   */
  private double apart() {
    double[] altitudes = room.altitudes(limits.horizonS());
    for (int i = 1; i < altitudes.length; i++) {
      Outcome outcome = forecast.play(bestMotion.at(altitudes[i]));
      if (outcome.freeM() == NEVER && outcome.meetsS() >= limits.horizonS()) {
        return altitudes[i];
      }
    }
    return Double.NaN;
  }

  /** Whether no motion both keeps the distance and makes progress. */
  private boolean isTrapped() {
    return best == null || leastScore >= DEAD_END * reachM;
  }

  /**
   * @param downM altitude [m]; NaN: that of the goal
   */
  private void arcs(double downM) {
    for (int direction = 0; direction < (limits.reverses() ? 2 : 1); direction++) {
      for (int k = -FAN; k <= FAN; k++) {
        double dislike = (double) Math.abs(k) / FAN;
        for (double share : SPEEDS) {
          boolean backwards = direction == 1;
          double most = limits.mps(backwards);
          double speed = limits.stops() ? share * most : most;
          Motion arc = Motion.arc(limits.tightest() * k / FAN, backwards, speed, reachM);
          weigh(arc.at(downM), dislike + (limits.stops() ? 1.0 - share : 0.0));
          if (!limits.stops()) {
            break;
          }
        }
      }
    }
  }

  /** Turns to directions fixed on the plane, which are stable while the vehicle turns. */
  private void turns() {
    for (int k = 0; k < DIRECTIONS; k++) {
      double turn = Pose.wrapped(2.0 * Math.PI * k / DIRECTIONS - pose.headingRad());
      if (Math.abs(turn) > MotionLimits.SPOT_TURN_RAD) {
        double dislike = 1.0 + 2.0 * Math.abs(turn) / Math.PI;
        weigh(Motion.turn(turn, limits.speedMps(), reachM), dislike);
      }
    }
  }

  private void weigh(Motion motion, double dislike) {
    for (double end : ENDS) {
      Motion ending = motion.endingAt(end * reachM);
      Pose to = end(ending);
      Outcome outcome = forecast.play(ending);
      double allowed = limits.stoppableMps(outcome.freeAndSeenM() - keptM);
      boolean free = limits.stops() ? allowed >= 0.5 * motion.speedMps() : outcome.freeM() == NEVER;
      ArcChoice choice =
          new ArcChoice(
              to.northM(),
              to.eastM(),
              free ? Math.min(motion.speedMps(), allowed) : motion.speedMps(),
              motion.backwards(),
              ArcChoice.Kind.EVADE,
              motion.toDownM());
      if (free) {
        boolean escapes =
            limits.stops() || motion.track() != null || forecast.canCircleAfter(motion);
        double score =
            Math.hypot(to.northM() - goalNorthM, to.eastM() - goalEastM)
                + reachM * (0.3 * dislike)
                + (motion.backwards() ? reachM : 0.0)
                + (motion.curvature() * side < 0.0 ? OTHER_SIDE * reachM : 0.0)
                + (escapes ? 0.0 : DEAD_END * reachM);
        if (outcome.meetsS() >= limits.horizonS() && score < leastScore) {
          leastScore = score;
          best = choice;
          bestMotion = ending;
        }
        consider(choice, outcome);
      } else if (!limits.stops() && outcome.freeM() > freestM) {
        freestM = outcome.freeM();
        freest = choice;
      }
      if (!amongTraffic || !limits.stops() || !free) {
        break; // its end only matters for traffic
      }
    }
  }

  private void consider(ArcChoice choice, Outcome outcome) {
    boolean wider = outcome.gapM() > widestM + SAME_M;
    boolean roomier = outcome.gapM() > widestM - SAME_M && outcome.roomM() > widestRoomM;
    if (wider || roomier) {
      widestM = Math.max(widestM, outcome.gapM());
      widestRoomM = outcome.roomM();
      widest = choice;
    }
  }

  private Pose end(Motion motion) {
    Pose turned = new Pose(pose.northM(), pose.eastM(), pose.headingRad() + motion.turnRad());
    return turned.along(motion.sign() * Math.min(reachM, motion.endM()), motion.curvature());
  }

  /** No motion keeps the clearance: chooses the one that stays farthest away. */
  private ArcChoice lastResort(Outcome standing, ArcChoice stand) {
    // If a collision is unavoidable, prefer to be stopped. If traffic is already that close, only
    // the clearance is violated, and the vehicle may leave.
    boolean touched = widestM <= Math.min(0.0, forecast.gapNowM() - limits.trafficM());
    boolean stands =
        standing != null
            && (touched
                || standing.gapM() > widestM + SAME_M
                || (standing.gapM() > widestM - SAME_M && standing.roomM() >= widestRoomM));
    if (stands) {
      return stand.as(standing.gapM() > 0.0 ? ArcChoice.Kind.WAIT : ArcChoice.Kind.BRAKE);
    }
    if (widest == null) {
      ArcChoice any = freest == null ? stand : freest;
      boolean climbs = room != null && amongTraffic && !limits.stops();
      return climbs
          ? any.as(ArcChoice.Kind.BRAKE).at(room.altitudes(limits.horizonS())[1])
          : any.as(ArcChoice.Kind.BRAKE);
    }
    return widest.as(widestM > 0.0 ? ArcChoice.Kind.EVADE : ArcChoice.Kind.BRAKE);
  }
}
