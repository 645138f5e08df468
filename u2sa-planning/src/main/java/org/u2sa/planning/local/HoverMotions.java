package org.u2sa.planning.local;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.Mover;

/**
 * Chooses where an aircraft that can stop evades traffic, wherever it hovers or on its straight way
 * there: nowhere while traffic leaves that free, otherwise one of many spots around it, at which it
 * waits. Motions are simulated (Fiorini, Shiller: Motion Planning in Dynamic Environments Using
 * Velocity Obstacles, International Journal of Robotics Research 17, 1998, with accelerations).
 * Traffic is surrounded by a spheroid, whose size grows with the time predicted. Immutable.
 */
public final class HoverMotions {
  private static final int DIRECTIONS = 16;
  private static final double[] ASIDE_M = {8.0, 16.0, 24.0, 32.0, 48.0};
  private static final double[] UP_M = {10.0, -10.0, 25.0, -25.0};
  private static final double[] BOTH_M = {16.0, 32.0}; // aside, combined with up or down
  private static final double AROUND_M = 60.0; // nearer to the position, spots lie around it
  private static final double STEP_S = 0.4;
  private static final double GROWTH = 0.08; // uncertainty per distance travelled by traffic
  private static final double CLOSER = 0.02; // smaller approaches inside a spheroid are free
  private static final double FENCE_BRAKING_MPS2 = 1.0; // as the Safety Manager assumes by default
  private static final double FENCE_SHARE = 1.3; // of the way to stop, for wind and delays
  private static final double FENCE_REACTION_S = 1.0; // likewise
  private static final double SLOWER = 0.8;
  private static final double STANDS_SHARE = 0.1;
  private static final double CHANGE_M = 10.0; // by which another free spot must be nearer
  private static final double ROOMY = 1.5; // distances beyond it are not distinguished
  private static final double MEAN_SHARE = 0.1;
  private static final double ASTRAY = 10.0; // cost of a spot from which it cannot return
  private static final double AT_PLACE_M = 1.0; // shorter ways are always free
  private static final double CLEARLY = 0.05; // difference of distances that justifies a change

  /**
   * A spot and what it leads to.
   *
   * @param spot on the plane [m]
   * @param speedMps speed on the way there now [m/s]
   * @param distance minimum distance to traffic within the horizon, in radii of the spheroids: 1
   *     keeps the clearance
   */
  public record Choice(Point spot, double speedMps, double distance) {}

  /**
   * @param room minimum distance, and a little of the mean
   * @param end position at the end: as far as there is room
   */
  private record Outcome(boolean isFree, double distance, double room, Point end) {}

  private final CostGrid costs;
  private final double circleM;
  private final List<Mover> traffic;
  private final double keptM; // from static obstacles
  private final MotionLimits limits;
  private final Optional<VerticalRoom> room;
  private final Area allowed;
  private final long micros;

  /**
   * @param circleM radius of the vehicle [m]
   * @param clearanceM distance to keep from static obstacles [m]
   * @param room room above and below; empty if it stays at its altitude
   * @param allowed area inside the fence
   */
  public HoverMotions(
      CostGrid costs,
      double circleM,
      double clearanceM,
      List<Mover> traffic,
      MotionLimits limits,
      Optional<VerticalRoom> room,
      Area allowed,
      long micros) {
    this.costs = costs;
    this.circleM = circleM;
    this.traffic = traffic;
    this.limits = limits;
    keptM = Math.max(limits.touchM(), clearanceM);
    this.room = room;
    this.allowed = allowed;
    this.micros = micros;
  }

  /**
   * Spot to evade to; empty if the straight way to a position, and hovering there, is free. The
   * straight way from each spot to the position stays inside the fence.
   *
   * @param at vehicle on the plane [m]
   * @param velocity of the vehicle [m/s]
   * @param to position on the plane [m]
   * @param before spot of the evasion under way; then the straight way must be clearly free, and
   *     stay inside the fence
   */
  public Optional<Choice> choose(Point at, Point velocity, Point to, Optional<Point> before) {
    double share = before.isPresent() ? 1.0 + 2.0 * CLEARLY : 1.0;
    boolean leadsBack = before.isEmpty() || isAllowed(at, to);
    if (leadsBack && (traffic.isEmpty() || play(at, velocity, to, true, share).isFree())) {
      return Optional.empty();
    }
    List<Point> spots = spots(to.minus(at).distance() < AROUND_M ? to : at);
    spots.add(at);
    before.ifPresent(spots::add);
    Choice best = null;
    double leastM = Double.POSITIVE_INFINITY;
    double widest = Double.NEGATIVE_INFINITY;
    for (Point spot : spots) {
      Outcome outcome = play(at, velocity, spot, false, 1.0);
      boolean returns = isAllowed(outcome.end(), to);
      boolean isFree = outcome.isFree() && returns;
      boolean isSame = before.filter(each -> each == spot).isPresent();
      double awayM = spot.minus(to).distance() - (isSame ? CHANGE_M : 0.0);
      double room = outcome.room() + (isSame ? CLEARLY : 0.0) - (returns ? 0.0 : ASTRAY);
      boolean isBetter =
          isFree ? awayM < leastM : leastM == Double.POSITIVE_INFINITY && room > widest;
      if (isBetter) {
        best = new Choice(outcome.end(), speedMps(at, outcome.end()), outcome.distance());
        widest = room;
        leastM = isFree ? awayM : leastM;
      }
    }
    return Optional.of(best);
  }

  /** Whether a straight way stays inside the fence, or leaves it only at its end. */
  private boolean isAllowed(Point from, Point to) {
    if (Math.hypot(to.x() - from.x(), to.y() - from.y()) < AT_PLACE_M) {
      return true;
    }
    return allowed.contains(to.x(), to.y())
        ? allowed.allows(from.x(), from.y(), to.x(), to.y())
        : allowed.allows(to.x(), to.y(), from.x(), from.y());
  }

  /** The same spot from another position. */
  public Choice again(Choice before, Point at) {
    return new Choice(before.spot(), speedMps(at, before.spot()), before.distance());
  }

  private List<Point> spots(Point middle) {
    List<Point> all = new ArrayList<>();
    for (int i = 0; i < DIRECTIONS; i++) {
      double bearing = 2.0 * Math.PI * i / DIRECTIONS;
      Point way = Point.of(Math.cos(bearing), Math.sin(bearing), 0.0);
      for (double aside : ASIDE_M) {
        all.add(middle.plus(way.times(aside)));
      }
      for (double aside : room.isEmpty() ? new double[0] : BOTH_M) {
        all.add(middle.plus(way.times(aside)).plus(Point.of(0.0, 0.0, -UP_M[0])));
        all.add(middle.plus(way.times(aside)).plus(Point.of(0.0, 0.0, -UP_M[1])));
      }
    }
    for (double up : room.isEmpty() ? new double[0] : UP_M) {
      all.add(middle.plus(Point.of(0.0, 0.0, -up)));
    }
    return all;
  }

  /**
   * Simulates the straight way to a spot, and waiting there.
   *
   * @param isWanted whether it goes there anyway, whatever room there is above and below
   * @param share of the clearance that must be kept
   */
  private Outcome play(Point at, Point velocity, Point to, boolean isWanted, double share) {
    double[] least = new double[traffic.size()];
    for (int i = 0; i < least.length; i++) {
      least[i] = Math.min(share, distance(traffic.get(i), at, 0.0) - CLOSER);
    }
    double north = at.x();
    double east = at.y();
    double down = at.z();
    double vNorth = velocity.x();
    double vEast = velocity.y();
    boolean isFree = true;
    double distance = Double.POSITIVE_INFINITY;
    double sum = 0.0;
    int looks = 0;
    for (double t = STEP_S; t <= limits.horizonS(); t += STEP_S) {
      if (t > limits.reactionS()) {
        double awayM = Math.max(1.0e-6, Math.hypot(to.x() - north, to.y() - east));
        double wanted = Math.min(speedMps(to, north, east), awayM / STEP_S);
        double dn = wanted * (to.x() - north) / awayM - vNorth;
        double de = wanted * (to.y() - east) / awayM - vEast;
        boolean brakes = wanted < Math.hypot(vNorth, vEast);
        double rate = brakes ? limits.brakingMps2() : limits.accelerationMps2();
        double part = Math.min(1.0, rate * STEP_S / Math.max(1.0e-9, Math.hypot(dn, de)));
        vNorth += part * dn;
        vEast += part * de;
        down = down(north, east, down, to.z(), isWanted);
      }
      double mps = Math.hypot(vNorth, vEast);
      double slower = mps == 0.0 ? 1.0 : insideMps(north, east, vNorth, vEast, mps) / mps;
      vNorth *= slower;
      vEast *= slower;
      double nextNorth = north + vNorth * STEP_S;
      double nextEast = east + vEast * STEP_S;
      boolean hits =
          !isWanted && room.isPresent() && isNewlyBlocked(north, east, nextNorth, nextEast, down);
      if (hits || isBlocked(north, east, nextNorth, nextEast)) {
        vNorth = 0.0;
        vEast = 0.0;
      } else {
        north = nextNorth;
        east = nextEast;
      }
      Point then = Point.of(north, east, down);
      for (int i = 0; i < least.length; i++) {
        double kept = distance(traffic.get(i), then, t);
        distance = Math.min(distance, kept);
        sum += Math.min(ROOMY, kept);
        looks++;
        isFree &= kept >= least[i];
      }
    }
    double mean = looks == 0 ? ROOMY : sum / looks; // its traffic has gone
    return new Outcome(isFree, distance, distance + MEAN_SHARE * mean, Point.of(north, east, down));
  }

  /** Speed on the way from a position to a spot, at which it stops, and stays inside the fence. */
  private double speedMps(Point at, Point spot) {
    double mps = speedMps(spot, at.x(), at.y());
    double awayM = Math.hypot(spot.x() - at.x(), spot.y() - at.y());
    return mps == 0.0
        ? 0.0
        : insideMps(
            at.x(),
            at.y(),
            mps * (spot.x() - at.x()) / awayM,
            mps * (spot.y() - at.y()) / awayM,
            mps);
  }

  /** Speed from which it stops at a spot [m/s]. */
  private double speedMps(Point to, double north, double east) {
    double awayM = Math.hypot(to.x() - north, to.y() - east);
    return Math.min(limits.speedMps(), Math.sqrt(2.0 * limits.brakingMps2() * awayM));
  }

  /** Whether a step leads into a static obstacle. */
  private boolean isBlocked(double north, double east, double nextNorth, double nextEast) {
    double nowM = costs.distanceM(north, east) - circleM;
    double nextM = costs.distanceM(nextNorth, nextEast) - circleM;
    return nextM < keptM && nextM < nowM;
  }

  /** Whether a level step leads into rising ground, or an obstacle at another altitude. */
  private boolean isNewlyBlocked(
      double north, double east, double nextNorth, double nextEast, double down) {
    VerticalRoom free = room.orElseThrow();
    return free.isBlocked(new Pose(nextNorth, nextEast, 0.0), down)
        && !free.isBlocked(new Pose(north, east, 0.0), down);
  }

  /** Speed, at most as given, from which it stops inside the fence, or nearer to it [m/s]. */
  private double insideMps(double north, double east, double vNorth, double vEast, double mps) {
    for (double share = 1.0; share > STANDS_SHARE; share *= SLOWER) {
      double slower = share * mps;
      double stopsM =
          FENCE_SHARE * (slower * FENCE_REACTION_S + slower * slower / (2.0 * FENCE_BRAKING_MPS2));
      double ahead = (stopsM + slower * STEP_S) / mps;
      if (allowed.allows(north, east, north + ahead * vNorth, east + ahead * vEast)) {
        return share * mps;
      }
    }
    return 0.0;
  }

  /** Altitude after a step towards another, as far as there is room. */
  private double down(double north, double east, double down, double toDown, boolean isWanted) {
    if (room.isEmpty()) {
      return down;
    }
    VerticalRoom free = room.get();
    double changeM = free.rateMps() * STEP_S;
    double next = down + Math.max(-changeM, Math.min(changeM, toDown - down));
    boolean isOutside =
        next < Math.min(free.topDownM(), down) || next > Math.max(free.bottomDownM(), down);
    boolean isBlocked = next != down && free.isBlocked(new Pose(north, east, 0.0), next);
    return !isWanted && (isOutside || isBlocked) ? down : next;
  }

  /** Distance from traffic at a time, in radii of its spheroid. */
  private double distance(Mover mover, Point at, double seconds) {
    double ageS = mover.ageS(micros) + seconds;
    double north = mover.northAfterM(ageS) - at.x();
    double east = mover.eastAfterM(ageS) - at.y();
    double grownM = GROWTH * Math.hypot(mover.northMps(), mover.eastMps()) * seconds;
    double keptM = mover.radiusM() + circleM + limits.trafficM() + grownM;
    double beside = Math.hypot(north, east) / keptM;
    if (room.isEmpty() || Double.isInfinite(mover.heights().halfM())) {
      return beside;
    }
    double grownUpM = GROWTH * Math.abs(mover.heights().downMps()) * seconds;
    double keptUpM = mover.heights().halfM() + room.get().clearanceM() + grownUpM;
    return Math.hypot(beside, (mover.downAfterM(ageS) - at.z()) / keptUpM);
  }
}
