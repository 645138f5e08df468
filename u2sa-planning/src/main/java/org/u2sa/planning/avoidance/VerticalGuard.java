package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Keeps a vehicle that can stop from climbing or descending into what is above or below it: routes
 * are planned at one altitude, and take-offs and landings without a route. Confined to the
 * planner's thread.
 */
final class VerticalGuard {
  private static final double MIN_M = 0.3; // shorter ways up and down are not checked
  private static final double CLOSER_SHARE =
      0.02; // of a ball's radius: smaller approaches are free
  private static final double GROUND_M = 0.5; // an object this much higher is not the ground
  private static final double STANDS_MPS = 0.5;
  private static final double NOWHERE = Double.POSITIVE_INFINITY;
  private static final long PATIENCE_MICROS = 300 * Clock.MICROS_PER_SECOND; // with traffic
  private static final long FREE_MICROS = 60 * Clock.MICROS_PER_SECOND; // longer: traffic has gone
  private static final double PROGRESS_M = 1.0;

  private final SeenWorld world;
  private final PursuitTime time;
  private final BiConsumer<String, Boolean> say;
  private String goal = "";
  private String said = "";
  private boolean isHeldUp;
  private long freeMicros; // pursuit time at which it was last not held up
  private long heldMicros; // when it was last held up
  private long progressMicros; // when it was last free for a while, or got farther than before
  private double lowestM; // altitude reached in descents to the goal
  private double highestM; // likewise in climbs

  /**
   * @param time time against which patience is measured
   * @param say reports a message to the operator; true for a warning
   */
  VerticalGuard(SeenWorld world, PursuitTime time, BiConsumer<String, Boolean> say) {
    this.world = world;
    this.time = time;
    this.say = say;
  }

  /** Whether a vertical way is long enough to be checked. */
  static boolean matters(Point way) {
    return Math.abs(way.z()) > MIN_M;
  }

  /**
   * Part of a vertical way that ends VERTICAL CLEARANCE before a static obstacle, as of the last
   * update of the world: down [m]. None within that distance of one or inside its outline, if the
   * way leads towards its middle: traffic that has stopped is a ball of its separation, and a
   * measured altitude wanders. An object of unknown height is no place to land on.
   *
   * @param at vehicle on the plane [m]
   * @param way to its next point; obstacles are looked for as far along it as the vehicle needs to
   *     stop
   * @param ground place to land on; empty if it does not land
   */
  double untilObstacle(
      Vehicle vehicle,
      Point at,
      Point way,
      Optional<Place> ground,
      BodyDiscs body,
      AvoidanceVariables now) {
    double keptM = body.circleM() + now.touchM(world.costs().frame().cellM());
    double speedMps = vehicle.speedMps();
    double reachM = speedMps * (now.reactionTime() + 0.5 * speedMps / now.plannedBraking());
    double lengthM = Math.hypot(way.x(), way.y());
    double share = lengthM > reachM ? reachM / lengthM : 1.0;
    int steps = (int) Math.ceil(share * lengthM / keptM);
    double highestM =
        ground.map(place -> at.z() + vehicle.nedOf(place).z() - GROUND_M).orElse(NOWHERE);
    double sign = Math.signum(way.z());
    double freeM = Math.abs(way.z());
    List<PlanarShape> shapes = new ArrayList<>(world.shapes());
    shapes.addAll(world.shapesElsewhere());
    for (PlanarShape shape : shapes) {
      double edge = sign > 0.0 ? shape.topDownM() : shape.bottomDownM();
      boolean isEndless = Double.isInfinite(edge) && ground.isPresent() && sign > 0.0;
      double aheadM = isEndless ? Double.MIN_VALUE : sign * (edge - at.z());
      boolean isInTheWay =
          (aheadM > 0.0 || nearsMiddle(shape, at, sign))
              && aheadM < freeM + now.verticalClearance()
              && edge < highestM;
      for (int i = 0; isInTheWay && i <= steps; i++) {
        double part = steps == 0 ? 0.0 : share * i / steps;
        if (shape.distanceM(at.x() + part * way.x(), at.y() + part * way.y()) < keptM) {
          freeM = Math.min(freeM, Math.max(0.0, aheadM - now.verticalClearance()));
        }
      }
    }
    return sign * freeM;
  }

  /**
   * Whether a vertical way leads towards the middle of a shape. A climb does not come closer to one
   * with vertical sides that reaches from the vehicle's altitude upwards, such as a wall.
   *
   * @param sign direction of the way: 1 down, −1 up
   */
  private static boolean nearsMiddle(PlanarShape shape, Point at, double sign) {
    double middleM = sign * (0.5 * (shape.topDownM() + shape.bottomDownM()) - at.z());
    if (!shape.isBall()) {
      return sign > 0.0 && middleM > 0.0;
    }
    double besideM = Math.hypot(at.x() - shape.northM(0), at.y() - shape.eastM(0));
    double closerM = Math.hypot(besideM, middleM) - besideM;
    return middleM > 0.0 && closerM > CLOSER_SHARE * shape.radiusM();
  }

  /** Whether traffic of unknown height is so close that it may be below. */
  static boolean isOver(List<Mover> traffic, Point at, double keptM, long micros) {
    for (Mover mover : traffic) {
      double age = mover.ageS(micros);
      double north = mover.northAfterM(age) - at.x();
      double east = mover.eastAfterM(age) - at.y();
      boolean isHigh = Double.isInfinite(mover.heights().halfM());
      if (isHigh && Math.hypot(north, east) < mover.radiusM() + keptM) {
        return true;
      }
    }
    return false;
  }

  /** Traffic of known height above the vehicle. */
  static List<Mover> above(List<Mover> traffic, Point at, long micros) {
    return traffic.stream()
        .filter(mover -> Double.isFinite(mover.heights().halfM()))
        .filter(mover -> mover.downAfterM(mover.ageS(micros)) < at.z())
        .collect(Collectors.toList());
  }

  boolean isHeldUp() {
    return isHeldUp;
  }

  /**
   * Reports once what holds the vehicle up.
   *
   * @param pursued UID of the goal
   * @param byObstacle whether an obstacle holds it up, not traffic
   * @return reason for giving up the goal, or empty
   */
  Optional<String> heldUp(
      String pursued,
      Vehicle vehicle,
      Point way,
      boolean held,
      boolean byObstacle,
      AvoidanceVariables now) {
    isHeldUp = held;
    long micros = time.micros();
    if (!goal.equals(pursued)) {
      goal = pursued;
      said = "";
      freeMicros = micros;
      heldMicros = micros;
      lowestM = Double.POSITIVE_INFINITY;
      highestM = Double.NEGATIVE_INFINITY;
    }
    boolean isHopeless = evadesForLong(vehicle, way, held) && !byObstacle;
    if (!isHopeless && (!held || vehicle.speedMps() > STANDS_MPS)) {
      freeMicros = micros;
      return Optional.empty();
    }
    String what =
        (byObstacle ? "an obstacle" : "traffic")
            + " is in the way of the "
            + (way.z() > 0.0 ? "descent" : "climb");
    if (!said.equals(what)) {
      say.accept(what + ": waiting", true);
      said = what;
    }
    long patienceMicros = byObstacle ? now.giveUpMicros() : PATIENCE_MICROS;
    return isHopeless || micros - freeMicros > patienceMicros
        ? Optional.of(what)
        : Optional.empty();
  }

  /** Whether evasions and new attempts have alternated for too long without progress. */
  private boolean evadesForLong(Vehicle vehicle, Point way, boolean held) {
    long micros = time.micros();
    double upM = vehicle.place().upM().orElse(0.0);
    boolean isLower = way.z() > 0.0 && upM < lowestM - PROGRESS_M;
    boolean isHigher = way.z() < 0.0 && upM > highestM + PROGRESS_M;
    lowestM = isLower ? upM : lowestM;
    highestM = isHigher ? upM : highestM;
    if (isLower || isHigher || micros - heldMicros > FREE_MICROS) {
      progressMicros = micros;
    }
    if (held) {
      heldMicros = micros;
    }
    return held && micros - progressMicros > PATIENCE_MICROS;
  }
}
