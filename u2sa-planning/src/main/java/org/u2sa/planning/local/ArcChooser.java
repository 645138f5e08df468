package org.u2sa.planning.local;

import java.util.List;
import java.util.Optional;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.MotionForecast.Outcome;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.Mover;
import org.u2sa.service.motion.Drift;

/**
 * Chooses the arc to drive or fly next: the one that leads back to the route if it is free,
 * otherwise the best of the motions from which the vehicle can stop in time ({@link Evasion}). Not
 * thread-safe.
 */
public final class ArcChooser {
  private static final int FAN = 10; // arcs to each side
  private static final double[] SPEEDS = {1.0, 0.6, 0.3};
  private static final double LOOKS_RAD = Math.toRadians(12.0); // bearing tolerance
  private static final double CLEARLY_MORE = 0.8; // shortfall ratio to prefer a nearer point
  private static final double SAME_M = 0.005;
  private static final double ROOMIER_M = 0.005; // difference in mean distance that matters
  private static final double SLOWEST = 0.4; // fraction of the speed, close to a route
  private static final double UNSEEN_MPS = 0.3; // in reverse, where nobody knows what is there
  private static final double SHORT_M = 0.35; // controls stop short of nearer points
  private static final double SHORT_MPS = 0.2; // on a leg that is about as short
  private static final double PASSED_M = 0.02;
  private static final double STILL_MPS = 0.1; // slower drift does not matter
  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final CostGrid costs;
  private final BodyDiscs body;
  private final MotionLimits limits;
  private final Pose pose;
  private final double speedMps;
  private final MotionForecast forecast;
  private final Evasion evasion;
  private final TurnRoom turnRoom;
  private final boolean backsOut; // already makes room in reverse
  private final boolean goesBack; // was in reverse
  private final Optional<VerticalRoom> room;
  private final Optional<SteeredChoice> drifting; // drift of a boat carried by wind and current

  /**
   * @param speedMps speed of the vehicle along its heading [m/s]; negative in reverse
   * @param nowMicros time of this pose [µs]
   * @param before previous choice, on the same plane
   * @param room room to climb and descend away from traffic, whose heights then matter; empty: all
   *     motions are level
   * @param drift of a boat that cannot move sideways; {@link Drift#NONE} for other vehicles
   */
  public ArcChooser(
      CostGrid costs,
      BodyDiscs body,
      List<Mover> movers,
      MotionLimits limits,
      Pose pose,
      double speedMps,
      long nowMicros,
      Optional<ArcChoice> before,
      Optional<VerticalRoom> room,
      Drift drift) {
    this.costs = costs;
    this.body = body;
    this.limits = limits;
    this.pose = pose;
    this.speedMps = speedMps;
    this.room = room;
    boolean makesRoom =
        before.filter(choice -> choice.kind() == ArcChoice.Kind.MAKE_ROOM).isPresent();
    backsOut = makesRoom && before.get().backwards();
    goesBack = before.filter(ArcChoice::backwards).isPresent();
    turnRoom = new TurnRoom(costs, body, limits, pose, speedMps, makesRoom);
    VerticalRoom heights = room.orElse(null);
    TrafficForecast traffic = new TrafficForecast(movers, body, limits, pose, nowMicros, heights);
    forecast = new MotionForecast(costs, body, traffic, heights, limits, pose, speedMps);
    evasion =
        new Evasion(
            forecast,
            limits,
            heights,
            !traffic.isEmpty(),
            before,
            pose,
            speedMps,
            costs.frame().cellM());
    drifting =
        !limits.stops() || !limits.turnsOnTheSpot() || drift.speedMps() < STILL_MPS
            ? Optional.empty()
            : Optional.of(
                new SteeredChoice(
                    new SteeredForecast(costs, body, traffic, limits, pose, speedMps, drift),
                    limits,
                    pose,
                    before));
  }

  /** Vertical way in place, down [m]: the wanted one, or one that keeps away from traffic. */
  public double inPlaceM(double wantedM) {
    return evasion.inPlaceM(wantedM);
  }

  public ArcChoice along(RouteTrack track) {
    if (drifting.isPresent() && !track.goesBackwards()) {
      double aheadM = limits.lookAheadM();
      Optional<ArcChoice> out =
          turnsTo(track.northAheadM(aheadM), track.eastAheadM(aheadM), false)
              ? toRoom().filter(drifting.get()::isFree)
              : Optional.empty();
      return out.orElseGet(() -> drifting.get().along(track));
    }
    boolean backwards = track.goesBackwards();
    double straight = straightMps();
    double least = 0.2 * limits.lookAheadM();
    ArcChoice roomiest = null;
    double leastLacksM = NEVER;
    // closer to the route if the arc to a farther point is blocked or cuts a corner
    for (double ahead = limits.lookAheadM(); ahead > least; ahead *= 0.6) {
      double north = track.northAheadM(ahead);
      double east = track.eastAheadM(ahead);
      if (turnsTo(north, east, backwards)) {
        if (roomiest != null) {
          break;
        }
        return turn(north, east, backwards, track);
      }
      double curvature = limits.curvatureTo(pose, north, east, backwards);
      for (double share : SPEEDS) {
        double most = share * limits.mps(backwards);
        // at the actual speed: assuming more would mistime the encounter with traffic
        double speed = limits.stops() ? Math.min(most, straight) : Math.max(most, speedMps);
        Motion motion = Motion.along(track, curvature, backwards, speed, ahead);
        Outcome outcome = forecast.play(motion);
        double allowed = limits.stoppableMps(outcome.freeM() - costs.frame().cellM());
        boolean last = 0.6 * ahead <= least;
        boolean free =
            limits.stops()
                ? allowed > 0.0 && (last || outcome.freeM() >= ahead)
                : outcome.freeM() == NEVER;
        double safe = Math.min(speed, Math.min(allowed, unseenMps(outcome)));
        if (free && outcome.meetsS() >= limits.horizonS()) {
          if (outcome.lacksM() < CLEARLY_MORE * leastLacksM - SAME_M) {
            leastLacksM = outcome.lacksM();
            double slow = Math.min(Math.min(straight, safe), closeMps(ahead));
            ArcChoice to = new ArcChoice(north, east, slow, backwards, ArcChoice.Kind.FOLLOW);
            roomiest = isShort(track) ? beyond(to, curvature) : to;
          }
          break;
        }
        if (free) {
          evasion.alsoConsider(
              new ArcChoice(north, east, safe, backwards, ArcChoice.Kind.BRAKE), motion, outcome);
        }
        if (!limits.stops() || !free) {
          break; // slowing down would not help
        }
      }
      if (leastLacksM <= SAME_M) {
        break;
      }
    }
    return roomiest == null ? evade(track) : roomiest;
  }

  /** Whether a control that stops short of a point may not drive a leg of the route at all. */
  private boolean isShort(RouteTrack track) {
    return limits.stops() && !limits.turnsOnTheSpot() && track.legM() < 2.0 * SHORT_M;
  }

  /** A slow motion farther along the arc, unless the point is farther away or was passed. */
  private ArcChoice beyond(ArcChoice to, double curvature) {
    double sign = to.backwards() ? -1.0 : 1.0;
    double leftM =
        sign
            * pose.distanceM(to.northM(), to.eastM())
            * Math.cos(bearingRad(to.northM(), to.eastM()));
    if (leftM >= SHORT_M || leftM <= PASSED_M) {
      return to;
    }
    Pose far = pose.along(sign * SHORT_M, curvature);
    double slow = Math.min(to.speedMps(), SHORT_MPS);
    return new ArcChoice(far.northM(), far.eastM(), slow, to.backwards(), to.kind());
  }

  /** Maximum speed of a route in reverse, over ground that may not have been seen [m/s]. */
  private double unseenMps(Outcome outcome) {
    double seen = limits.stoppableMps(outcome.seenM() - costs.frame().cellM());
    return Math.max(UNSEEN_MPS, seen);
  }

  /** Speed to follow a route closely, with the usual look-ahead time [m/s]. */
  private double closeMps(double aheadM) {
    return limits.preferredM() == 0.0
        ? limits.speedMps()
        : limits.speedMps() * Math.max(SLOWEST, aheadM / limits.lookAheadM());
  }

  private ArcChoice turn(double north, double east, boolean backwards, RouteTrack track) {
    if (turnRoom.isTooNarrow()) {
      return makeRoom(ArcChoice.Kind.EVADE);
    }
    Optional<ArcChoice> out = toRoom();
    if (out.isPresent()) {
      return turnRoom.standsFirst() ? stand(ArcChoice.Kind.EVADE) : out.get();
    }
    if (forecast.standing(Double.NaN).meetsS() < limits.horizonS()
        || room.isPresent() && !isFreeAfterTurn(north, east, track)) {
      return evade(track);
    }
    return turnRoom.turnsAtOnce()
        ? new ArcChoice(north, east, limits.speedMps(), backwards, ArcChoice.Kind.FOLLOW)
        : stand(ArcChoice.Kind.EVADE);
  }

  /**
   * Whether the way along the route is free of traffic after a turn towards it: an aircraft begins
   * to move that way while it still turns.
   */
  private boolean isFreeAfterTurn(double north, double east, RouteTrack track) {
    double speed = limits.speedMps();
    Motion motion = Motion.turn(bearingRad(north, east), speed, pose.distanceM(north, east), track);
    Outcome outcome = forecast.play(motion);
    if (outcome.meetsS() >= limits.horizonS()) {
      return true;
    }
    evasion.alsoConsider(
        new ArcChoice(north, east, speed, false, ArcChoice.Kind.BRAKE), motion, outcome);
    return false;
  }

  /** Moves to a position with room to turn; stops first if still rolling. */
  private ArcChoice makeRoom(ArcChoice.Kind standing) {
    if (turnRoom.standsFirst()) {
      return stand(standing);
    }
    ArcChoice out = backOut(2.0 * body.circleM(), true);
    return out.kind() == ArcChoice.Kind.EVADE ? out.as(ArcChoice.Kind.MAKE_ROOM) : out;
  }

  /**
   * Moves to where it can turn and keeps its clearance, by the better way ahead or in reverse;
   * empty if it need not, or if there is no such way.
   */
  private Optional<ArcChoice> toRoom() {
    if (!limits.reverses() || room.isPresent() || !turnRoom.isTight()) {
      return Optional.empty();
    }
    RoomSearch search = new RoomSearch(costs, body, limits, pose);
    Optional<RoomSearch.Way> back = search.best(true);
    Optional<RoomSearch.Way> ahead = search.best(false);
    boolean isBackFirst =
        turnRoom.makesRoom() // otherwise it would go to and fro
            ? backsOut
            : ahead.isEmpty() || back.isPresent() && back.get().costM() <= ahead.get().costM();
    Optional<ArcChoice> first = (isBackFirst ? back : ahead).flatMap(this::onWay);
    return first.or(() -> (isBackFirst ? ahead : back).flatMap(this::onWay));
  }

  /** The motion on a way; empty if traffic comes close. */
  private Optional<ArcChoice> onWay(RoomSearch.Way way) {
    double speed = Math.min(0.5 * limits.speedMps(), limits.mps(way.backwards()));
    double wayM = Math.max(way.wayM(), body.circleM());
    Outcome outcome = forecast.play(Motion.arc(way.curvature(), way.backwards(), speed, wayM));
    double safe = Math.min(speed, limits.stoppableMps(outcome.freeM() - costs.frame().cellM()));
    if (safe <= 0.0 || outcome.meetsS() < limits.horizonS()) {
      return Optional.empty();
    }
    double toM = Math.min(wayM, outcome.freeM());
    Pose end = pose.along(way.backwards() ? -toM : toM, way.curvature());
    return Optional.of(
        new ArcChoice(end.northM(), end.eastM(), safe, way.backwards(), ArcChoice.Kind.MAKE_ROOM));
  }

  /** Maximum speed to stop straight ahead [m/s]: a new route may demand a turn in place. */
  private double straightMps() {
    if (!limits.turnsOnTheSpot()) {
      return limits.speedMps();
    }
    Motion straight = Motion.arc(0.0, false, limits.speedMps(), limits.lookAheadM());
    double freeM = forecast.play(straight).freeM();
    return Math.max(2.0 * TurnRoom.CREEPS_MPS, limits.stoppableMps(freeM - costs.frame().cellM()));
  }

  private ArcChoice evade(RouteTrack track) {
    double ahead = limits.lookAheadM();
    return evasion.choose(
        track.northAheadM(ahead), track.eastAheadM(ahead), stand(ArcChoice.Kind.WAIT));
  }

  /**
   * Stops at the stopping point, on an arc if something is in the way straight ahead; vehicles that
   * cannot stop fly straight on.
   */
  private ArcChoice stand(ArcChoice.Kind kind) {
    double curvature = limits.stops() ? forecast.stoppingCurvature() : 0.0;
    Pose ahead = pose.along(limits.lookAheadM(), curvature);
    return new ArcChoice(
        ahead.northM(), ahead.eastM(), limits.stops() ? 0.0 : limits.speedMps(), false, kind);
  }

  /** Chooses the freest arc for a vehicle without a route; stops if it can. */
  public ArcChoice withoutRoute() {
    ArcChoice stand = stand(ArcChoice.Kind.WAIT);
    if (drifting.isPresent() && !drifting.get().waits()) {
      return drifting.get().evade(pose.northM(), pose.eastM());
    }
    boolean waits = limits.stops() && forecast.standing(Double.NaN).meetsS() >= limits.horizonS();
    return waits ? stand : evasion.choose(pose.northM(), pose.eastM(), stand);
  }

  /** Makes a vehicle that cannot stop circle, to the right if there is room. */
  public ArcChoice circle() {
    Pose beside = new Pose(pose.northM(), pose.eastM(), pose.headingRad() + 0.5 * Math.PI);
    Pose middle = beside.along(limits.turnRadiusM(), 0.0);
    return evasion.choose(middle.northM(), middle.eastM(), stand(ArcChoice.Kind.WAIT));
  }

  /** Turns in place toward a heading, or first moves to where there is room to turn. */
  public ArcChoice lookTo(double headingRad) {
    if (!limits.turnsOnTheSpot() || forecast.standing(Double.NaN).meetsS() < limits.horizonS()) {
      return withoutRoute();
    }
    if (turnRoom.isTooNarrow()) {
      return makeRoom(ArcChoice.Kind.WAIT);
    }
    double off = Math.abs(Pose.wrapped(headingRad - pose.headingRad()));
    return off < LOOKS_RAD || !turnRoom.turnsAtOnce()
        ? stand(ArcChoice.Kind.WAIT)
        : new ArcChoice(
            pose.northM() + limits.lookAheadM() * Math.cos(headingRad),
            pose.eastM() + limits.lookAheadM() * Math.sin(headingRad),
            limits.speedMps(),
            false,
            ArcChoice.Kind.EVADE);
  }

  /**
   * Chooses the longest free path in reverse or, if necessary, forward, to leave a corner. Without
   * one it backs over ground that was never seen or, if that is not possible either, acts as {@link
   * #withoutRoute()}, because traffic may come while the vehicle waits.
   */
  public ArcChoice backOut(double wayM) {
    return backOut(wayM, goesBack);
  }

  /**
   * @param blind whether it prefers unseen ground in reverse to the way ahead
   */
  private ArcChoice backOut(double wayM, boolean blind) {
    LongestWay way = new LongestWay(wayM);
    if (limits.reverses()) {
      way.look(true, false);
      if (blind && way.best == null) {
        way.look(true, true);
      }
    }
    if (way.best == null || !backsOut) { // a longer way ahead would make it go to and fro
      way.look(false, false);
    }
    if (limits.reverses() && way.best == null) {
      way.look(true, true);
    }
    return way.best == null ? withoutRoute() : way.best;
  }

  /** Like {@link #backOut}, but forward only. */
  public ArcChoice ahead(double wayM) {
    LongestWay way = new LongestWay(wayM);
    way.look(false, false);
    return way.best == null ? withoutRoute() : way.best;
  }

  /** The longest arc or, among those that are about as long, one that keeps clearly more room. */
  private final class LongestWay {
    private final double wayM;
    private ArcChoice best;
    private double most;
    private double roomM;

    LongestWay(double wayM) {
      this.wayM = wayM;
      most = 0.1 * wayM;
    }

    /**
     * @param blind whether it may lead over unseen ground, slowly
     */
    void look(boolean backwards, boolean blind) {
      if (most >= wayM) {
        return;
      }
      for (int side = 0; side <= 2 * FAN; side++) {
        int k = (side % 2 == 0 ? 1 : -1) * ((side + 1) / 2); // straight first
        double curvature = limits.tightest() * k / FAN;
        double speed = Math.min(0.5 * limits.speedMps(), limits.mps(backwards));
        Outcome outcome = forecast.play(Motion.arc(curvature, backwards, speed, wayM));
        double untilM = blind ? outcome.freeM() : outcome.freeAndSeenM();
        double free = Math.min(wayM, untilM);
        double safe = Math.min(speed, limits.stoppableMps(untilM - costs.frame().cellM()));
        if (safe <= 0.0 || outcome.meetsS() < limits.horizonS() || free < most - SAME_M) {
          continue;
        }
        boolean isLonger = free > most + 0.05 * wayM;
        double thereM = forecast.roomM(curvature, backwards, free);
        Pose end = pose.along((backwards ? -1.0 : 1.0) * free, curvature);
        boolean isRoomier =
            best != null
                && best.backwards() == backwards
                && !costs.isUnseen(end.northM(), end.eastM())
                && thereM > roomM + ROOMIER_M;
        if (isLonger || isRoomier) {
          most = Math.max(most, free);
          roomM = thereM;
          double mps = blind ? Math.min(safe, unseenMps(outcome)) : safe;
          best = new ArcChoice(end.northM(), end.eastM(), mps, backwards, ArcChoice.Kind.EVADE);
        }
      }
    }
  }

  private boolean turnsTo(double north, double east, boolean backwards) {
    if (!limits.turnsOnTheSpot() || backwards || pose.distanceM(north, east) < 1.0e-3) {
      return false;
    }
    return Math.abs(bearingRad(north, east)) > MotionLimits.SPOT_TURN_RAD;
  }

  /** Bearing of a point from the heading, right positive [rad]. */
  private double bearingRad(double north, double east) {
    double course = Math.atan2(east - pose.eastM(), north - pose.northM());
    return Pose.wrapped(course - pose.headingRad());
  }
}
