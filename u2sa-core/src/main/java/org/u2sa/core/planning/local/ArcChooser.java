package org.u2sa.core.planning.local;

import java.util.List;
import org.u2sa.core.planning.curve.Pose;
import org.u2sa.core.planning.route.Route;
import org.u2sa.core.planning.search.BodyDiscs;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.seen.Mover;

/**
 * Chooses the arc to drive or fly next: the one that leads back to the route if nothing is in the
 * way, otherwise the best of a fan of arcs and speeds that can be reached and stopped from in time
 * (Fox, Burgard, Thrun: The Dynamic Window Approach to Collision Avoidance, IEEE Robotics and
 * Automation Magazine 4, 1997, with arcs in place of velocities: at a given speed they are the
 * same).
 *
 * <p>Traffic is where its velocity will have taken it: a motion that meets it within the horizon
 * lies in its velocity obstacle (Fiorini, Shiller: Motion Planning in Dynamic Environments Using
 * Velocity Obstacles, International Journal of Robotics Research 17, 1998). Belongs to one thread.
 */
public final class ArcChooser {
  /** A vehicle that turns on the spot drives arcs to points this near to straight ahead [rad]. */
  private static final double SPOT_TURN_RAD = Math.toRadians(30.0);

  private static final int FAN = 10; // arcs to each side
  private static final double[] SPEEDS = {1.0, 0.6, 0.3};
  private static final double GROWTH = 0.08; // of traffic's way: how well its velocity is known
  private static final double DEAD_END = 10.0; // look-aheads that a motion without escape costs
  private static final double CREEPS_MPS = 0.15;
  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final CostGrid costs;
  private final BodyDiscs body;
  private final List<Mover> movers;
  private final MotionLimits limits;
  private final Pose pose;
  private final double speedMps;
  private final long nowMicros;
  private final double dtS;
  private double gapM; // least between bodies in the motion played forward

  /** What comes of a motion. */
  private record Outcome(double freeM, double meetsS, boolean escapes, double gapM) {}

  /**
   * @param speedMps of the vehicle along its heading [m/s]; negative backwards
   * @param nowMicros when it is there [µs]
   */
  public ArcChooser(
      CostGrid costs,
      BodyDiscs body,
      List<Mover> movers,
      MotionLimits limits,
      Pose pose,
      double speedMps,
      long nowMicros) {
    this.costs = costs;
    this.body = body;
    this.movers = movers;
    this.limits = limits;
    this.pose = pose;
    this.speedMps = speedMps;
    this.nowMicros = nowMicros;
    dtS = Math.max(0.02, 0.7 * costs.frame().cellM() / Math.max(0.1, limits.speedMps()));
  }

  /** The next motion along a route. */
  public ArcChoice along(RouteTrack track) {
    boolean backwards = track.goesBackwards();
    double straight = straightMps();
    ArcChoice best = null;
    double widest = -NEVER;
    for (double ahead = limits.lookAheadM();
        ahead > 0.2 * limits.lookAheadM();
        ahead *= 0.6) { // nearer to the route where the arc to a farther point is not free
      double north = track.northAheadM(ahead);
      double east = track.eastAheadM(ahead);
      if (turnsTo(north, east, backwards)) {
        if (!canTurnHere()) {
          return Math.abs(speedMps) > CREEPS_MPS
              ? stand(ArcChoice.Kind.EVADE)
              : backOut(2.0 * body.circleM());
        }
        ArcChoice turn =
            new ArcChoice(north, east, limits.speedMps(), backwards, ArcChoice.Kind.FOLLOW);
        return meetsS(standing()) >= limits.horizonS() ? turn : evadeOrWait(track);
      }
      double curvature = curvatureTo(pose, north, east, backwards);
      for (double share : SPEEDS) {
        double speed = Math.max(share * limits.speedMps(), limits.stops() ? 0.0 : speedMps);
        Outcome outcome = drive(curvature, backwards, speed, ahead, track);
        double allowed = allowedMps(outcome.freeM());
        boolean last = 0.6 * ahead <= 0.2 * limits.lookAheadM();
        boolean free =
            limits.stops()
                ? allowed > 0.0 && (last || outcome.freeM() >= ahead)
                : outcome.freeM() == NEVER;
        if (free && outcome.meetsS() >= limits.horizonS()) {
          return new ArcChoice(
              north,
              east,
              Math.min(straight, Math.min(speed, allowed)),
              backwards,
              ArcChoice.Kind.FOLLOW);
        }
        if (free && outcome.gapM() > widest) {
          widest = outcome.gapM();
          best =
              new ArcChoice(north, east, Math.min(speed, allowed), backwards, ArcChoice.Kind.BRAKE);
        }
        if (!limits.stops() || !free) {
          break; // slower is not freer
        }
      }
    }
    return evade(track, best, widest);
  }

  /** Whether the vehicle may turn on the spot where it comes to stand: its corners reach far. */
  private boolean canTurnHere() {
    double stopping = Math.copySign(limits.stoppingM(Math.abs(speedMps)), speedMps);
    Pose there = pose.along(stopping, 0.0);
    return costs.distanceM(there.northM(), there.eastM()) >= body.circleM();
  }

  /**
   * The speed from which it can still stop straight ahead [m/s]: a new route may order a turn on
   * the spot at any moment.
   */
  private double straightMps() {
    if (!limits.turnsOnTheSpot()) {
      return limits.speedMps();
    }
    Outcome straight = drive(0.0, false, limits.speedMps(), limits.lookAheadM(), null);
    return Math.max(2.0 * CREEPS_MPS, allowedMps(straight.freeM()));
  }

  private ArcChoice evadeOrWait(RouteTrack track) {
    return evade(track, null, -NEVER);
  }

  /** The best arc of the fan, or to wait; if all come too near, what stays farthest away. */
  private ArcChoice evade(RouteTrack track, ArcChoice lastResort, double widestM) {
    double goalNorth = track.northAheadM(limits.lookAheadM());
    double goalEast = track.eastAheadM(limits.lookAheadM());
    double now = pose.distanceM(goalNorth, goalEast);
    ArcChoice best = null;
    double least = NEVER;
    ArcChoice freest = null; // of those that meet something that stands
    double freestM = -1.0;
    ArcChoice resort = lastResort;
    double widest = widestM;
    double reach = Math.max(limits.lookAheadM(), 1.2 * limits.stoppingM(Math.abs(speedMps)));
    for (int direction = 0; direction < (limits.reverses() ? 2 : 1); direction++) {
      boolean backwards = direction == 1;
      for (int k = -FAN; k <= FAN; k++) {
        double curvature = tightest() * k / FAN;
        for (double share : SPEEDS) {
          double speed = limits.stops() ? share * limits.speedMps() : limits.speedMps();
          Outcome outcome = drive(curvature, backwards, speed, reach, null);
          double allowed = allowedMps(outcome.freeM());
          boolean free = limits.stops() ? allowed >= 0.5 * speed : outcome.freeM() == NEVER;
          Pose end = pose.along((backwards ? -1.0 : 1.0) * reach, curvature);
          if (!free) {
            if (!limits.stops() && outcome.freeM() > freestM) {
              freestM = outcome.freeM();
              freest =
                  new ArcChoice(end.northM(), end.eastM(), speed, backwards, ArcChoice.Kind.BRAKE);
            }
            continue;
          }
          double score =
              Math.hypot(end.northM() - goalNorth, end.eastM() - goalEast)
                  + 0.3 * reach * Math.abs(k) / FAN
                  + (backwards ? reach : 0.0)
                  + (outcome.escapes() ? 0.0 : DEAD_END * reach)
                  + 0.2 * reach * (1.0 - share);
          ArcChoice choice =
              new ArcChoice(
                  end.northM(),
                  end.eastM(),
                  Math.min(speed, allowed),
                  backwards,
                  ArcChoice.Kind.EVADE);
          if (outcome.meetsS() >= limits.horizonS() && score < least) {
            least = score;
            best = choice;
          }
          if (outcome.gapM() > widest) {
            widest = outcome.gapM();
            resort =
                new ArcChoice(
                    choice.northM(),
                    choice.eastM(),
                    choice.speedMps(),
                    backwards,
                    ArcChoice.Kind.BRAKE);
          }
          if (!limits.stops()) {
            break;
          }
        }
      }
    }
    Outcome standing = limits.stops() ? standing() : null;
    boolean waits = standing != null && standing.meetsS() >= limits.horizonS();
    if (best != null && (!waits || least < 1.2 * now)) {
      return best;
    }
    if (waits) {
      return stand(ArcChoice.Kind.WAIT);
    }
    // Whatever it does, something comes nearer than it should: as far from it as can be.
    if (standing != null && (standing.gapM() >= widest || widest <= 0.0)) {
      return stand(standing.gapM() > 0.0 ? ArcChoice.Kind.WAIT : ArcChoice.Kind.BRAKE);
    }
    if (resort == null) {
      return freest == null ? stand(ArcChoice.Kind.BRAKE) : freest;
    }
    return new ArcChoice(
        resort.northM(),
        resort.eastM(),
        resort.speedMps(),
        resort.backwards(),
        widest > 0.0 ? ArcChoice.Kind.EVADE : ArcChoice.Kind.BRAKE);
  }

  /** To stand where the vehicle comes to stand; one that cannot flies straight on. */
  public ArcChoice stand(ArcChoice.Kind kind) {
    Pose ahead = pose.along(limits.lookAheadM(), 0.0);
    return new ArcChoice(
        ahead.northM(), ahead.eastM(), limits.stops() ? 0.0 : limits.speedMps(), false, kind);
  }

  /** The freest arc, for a vehicle that has no route; it stands if it can. */
  public ArcChoice withoutRoute() {
    if (limits.stops()) {
      return meetsS(standing()) >= limits.horizonS()
          ? stand(ArcChoice.Kind.WAIT)
          : evade(here(), null, -NEVER);
    }
    return evade(here(), null, -NEVER);
  }

  /** A route that leads nowhere else. */
  private RouteTrack here() {
    return new RouteTrack(
        Route.of(List.of(new Route.Point(pose.northM(), pose.eastM(), false)), 0.0));
  }

  /** The longest free way backwards or, if need be, forwards, to get out of a corner. */
  public ArcChoice backOut(double wayM) {
    ArcChoice best = stand(ArcChoice.Kind.WAIT);
    double most = 0.1 * wayM;
    boolean canReverse = limits.reverses();
    for (int direction = canReverse ? 1 : 0; direction >= 0 && most < wayM; direction--) {
      boolean backwards = direction == 1;
      for (int side = 0; side <= 2 * FAN; side++) {
        int k = (side % 2 == 0 ? 1 : -1) * ((side + 1) / 2); // straight first
        double curvature = tightest() * k / FAN;
        Outcome outcome = drive(curvature, backwards, 0.5 * limits.speedMps(), wayM, null);
        double free = Math.min(wayM, outcome.freeM());
        if (free > most + 0.05 * wayM && outcome.meetsS() >= limits.horizonS()) {
          most = free;
          Pose end = pose.along((backwards ? -1.0 : 1.0) * free, curvature);
          best =
              new ArcChoice(
                  end.northM(),
                  end.eastM(),
                  0.5 * limits.speedMps(),
                  backwards,
                  ArcChoice.Kind.EVADE);
        }
      }
    }
    return best;
  }

  private boolean turnsTo(double north, double east, boolean backwards) {
    if (!limits.turnsOnTheSpot() || backwards || pose.distanceM(north, east) < 1.0e-3) {
      return false;
    }
    double bearing = Math.atan2(east - pose.eastM(), north - pose.northM()) - pose.headingRad();
    return Math.abs(Pose.wrapped(bearing)) > SPOT_TURN_RAD;
  }

  /** Of the arc to a point, tangent to the heading (Coulter, CMU-RI-TR-92-01: 2 y / L²). */
  private double curvatureTo(Pose from, double north, double east, boolean backwards) {
    double dn = north - from.northM();
    double de = east - from.eastM();
    double right = de * Math.cos(from.headingRad()) - dn * Math.sin(from.headingRad());
    double ahead = dn * Math.cos(from.headingRad()) + de * Math.sin(from.headingRad());
    double square = dn * dn + de * de;
    if (square < 1.0e-6) {
      return 0.0;
    }
    boolean wrongSide = backwards ? ahead > 0.0 : ahead < 0.0;
    double wanted = wrongSide ? Math.copySign(tightest(), right) : 2.0 * right / square;
    return Math.max(-tightest(), Math.min(tightest(), wanted));
  }

  private double tightest() {
    return limits.turnsOnTheSpot()
        ? 2.0 * Math.sin(SPOT_TURN_RAD) / limits.lookAheadM()
        : 1.0 / limits.turnRadiusM();
  }

  /** The speed from which it stops before what is in the way [m/s]; 0: it is too late or no use. */
  private double allowedMps(double freeM) {
    if (freeM == NEVER) {
      return limits.speedMps();
    }
    double left = freeM - costs.frame().cellM();
    if (left <= 0.0) {
      return 0.0;
    }
    double b = limits.brakingMps2() * limits.reactionS(); // v²/2b + v t = left
    return Math.min(limits.speedMps(), Math.sqrt(b * b + 2.0 * limits.brakingMps2() * left) - b);
  }

  private Outcome standing() {
    gapM = NEVER;
    double meets = NEVER;
    double v = Math.abs(speedMps);
    Pose at = pose;
    for (double t = 0.0; t <= limits.horizonS(); t += dtS) {
      if (t > limits.reactionS()) {
        v = Math.max(0.0, v - limits.brakingMps2() * dtS);
      }
      at = at.along(Math.copySign(v * dtS, speedMps), 0.0);
      if (meetsTraffic(at, t) && meets == NEVER) {
        meets = t;
      }
    }
    return new Outcome(NEVER, meets, true, gapM);
  }

  private static double meetsS(Outcome outcome) {
    return outcome.meetsS();
  }

  /**
   * What comes of driving an arc and then along the route, or straight on: how far it is free, when
   * it meets traffic.
   */
  private Outcome drive(
      double curvature, boolean backwards, double wantedMps, double arcM, RouteTrack track) {
    double sign = backwards ? -1.0 : 1.0;
    double v = Math.max(0.0, sign * speedMps);
    double stopping = limits.stops() ? limits.stoppingM(Math.max(v, wantedMps)) : 0.0;
    double far = limits.stops() ? stopping + 2.0 * costs.frame().cellM() : turnBackM(track);
    double farM = Math.max(arcM, far);
    double gone = 0.0;
    gapM = NEVER;
    double freeM = NEVER;
    double meets = NEVER;
    Pose at = pose;
    double startClearance = clearanceM(pose);
    double required = Math.min(limits.touchM(), startClearance - 1.0e-6);
    boolean looksAtTraffic = !movers.isEmpty();
    for (double t = 0.0; t <= limits.horizonS() || gone < farM; t += dtS) {
      double change = wantedMps > v ? limits.accelerationMps2() : limits.brakingMps2();
      v += Math.max(-change * dtS, Math.min(change * dtS, wantedMps - v));
      double step = v * dtS;
      gone += step;
      at = next(at, sign, step, gone, arcM, curvature, track);
      if (freeM == NEVER && gone <= farM + step) {
        if (clearanceM(at) < required) {
          freeM = gone - step;
        }
      }
      if (looksAtTraffic && t <= limits.horizonS() && meetsTraffic(at, t) && meets == NEVER) {
        meets = t;
      }
      boolean seenAll = gone >= farM && !looksAtTraffic;
      if (seenAll || freeM < NEVER || (v < 1.0e-3 && t > limits.horizonS())) {
        break;
      }
    }
    boolean escapes =
        limits.stops()
            || track != null // planned as it can be flown, to the goal
            || (freeM == NEVER && circles(pose.along(sign * arcM, curvature)));
    return new Outcome(freeM, meets, escapes, gapM);
  }

  /** How far what cannot stop looks ahead: on its route as far as it takes to turn back [m]. */
  private double turnBackM(RouteTrack track) {
    return track == null ? 0.0 : Math.min(4.0 * limits.turnRadiusM(), track.remainingM());
  }

  private Pose next(
      Pose at,
      double sign,
      double step,
      double gone,
      double arcM,
      double curvature,
      RouteTrack track) {
    if (gone <= arcM || track == null) {
      return at.along(sign * step, gone <= arcM ? curvature : 0.0);
    }
    if (!limits.stops()) { // off its route it has to fly back, and meets what is on the way
      double ahead = gone + limits.lookAheadM();
      return at.along(
          step, curvatureTo(at, track.northAheadM(ahead), track.eastAheadM(ahead), false));
    }
    double north = track.northAheadM(gone);
    double east = track.eastAheadM(gone);
    double heading = Math.atan2(sign * (east - at.eastM()), sign * (north - at.northM()));
    boolean stays = Math.hypot(east - at.eastM(), north - at.northM()) < 1.0e-6;
    return new Pose(north, east, stays ? at.headingRad() : heading);
  }

  /** Whether what cannot stop can circle from there, to one side or the other. */
  private boolean circles(Pose from) {
    double radius = 1.1 * limits.turnRadiusM();
    double step = Math.max(costs.frame().cellM(), 0.1 * radius);
    for (int side = -1; side <= 1; side += 2) {
      boolean free = true;
      for (double gone = 0.0; gone < 2.0 * Math.PI * radius && free; gone += step) {
        free = clearanceM(from.along(gone, side / radius)) >= limits.touchM();
      }
      if (free) {
        return true;
      }
    }
    return false;
  }

  private double clearanceM(Pose at) {
    return body.clearanceM(costs, at.northM(), at.eastM(), at.headingRad());
  }

  /** Whether traffic is too near then, and not merely as near as it is now. */
  private boolean meetsTraffic(Pose at, double seconds) {
    boolean meets = false;
    for (Mover mover : movers) {
      double age = mover.ageS(nowMicros);
      double n = mover.northAfterM(age + seconds);
      double e = mover.eastAfterM(age + seconds);
      double grown = GROWTH * Math.hypot(mover.northMps(), mover.eastMps()) * seconds;
      double kept = mover.radiusM() + body.radiusM() + limits.trafficM() + grown;
      double cos = Math.cos(at.headingRad());
      double sin = Math.sin(at.headingRad());
      for (int disc = 0; disc < body.count(); disc++) {
        double along = body.aheadM(disc);
        double away = Math.hypot(at.northM() + along * cos - n, at.eastM() + along * sin - e);
        gapM = Math.min(gapM, away - mover.radiusM() - body.radiusM());
        if (away < kept && away < nowAwayM(mover, age, disc) - 0.02 * mover.radiusM()) {
          meets = true;
        }
      }
    }
    return meets;
  }

  private double nowAwayM(Mover mover, double age, int disc) {
    double north = pose.northM() + body.aheadM(disc) * Math.cos(pose.headingRad());
    double east = pose.eastM() + body.aheadM(disc) * Math.sin(pose.headingRad());
    return Math.hypot(north - mover.northAfterM(age), east - mover.eastAfterM(age));
  }
}
