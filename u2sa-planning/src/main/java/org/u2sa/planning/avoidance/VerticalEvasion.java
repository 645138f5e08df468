package org.u2sa.planning.avoidance;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.DoubleBinaryOperator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.seen.GroundMap;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Determines how far corridors, terrain and the fence let the vehicle climb and descend away from
 * traffic, and reports evasions. Confined to the planner's thread.
 */
final class VerticalEvasion {
  private static final double LOW_M = 1.0; // height above known ground, to which it may descend
  private static final double SAME_M = 1.0; // deviations below this count as level
  private static final double LEVELS_MPS2 = 0.8; // as the Safety Manager assumes by default
  private static final double REACTION_S = 1.0; // likewise
  private static final double LEVELS_SHARE = 1.3; // of the way to level off, for delays
  private static final long LASTS_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private final GroundMap ground;
  private final BiConsumer<String, Boolean> say;
  private Optional<FenceState> fence = Optional.empty();
  private int direction; // direction of the last evasion: 1 up, −1 down
  private long lastMicros = Long.MIN_VALUE / 2;

  VerticalEvasion(GroundMap ground, BiConsumer<String, Boolean> say) {
    this.ground = ground;
    this.say = say;
  }

  /** Receives the fence in force, whose altitude limits it respects. */
  void see(FenceState inForce) {
    fence = Optional.of(inForce);
  }

  /**
   * Room to evade in; empty if the vehicle does not climb to evade, or altitudes are unknown.
   *
   * @param at vehicle on the plane [m]
   * @param toGoal vector to the goal [m]
   * @param spot known ground below it on the plane [m]; empty if only the map is known
   */
  Optional<VerticalRoom> room(
      StateInformation state,
      Point at,
      Point toGoal,
      Place target,
      AvoidanceVariables now,
      SeenWorld world,
      PlanningPlane plane,
      Optional<Point> spot) {
    boolean areKnown = state.z().isPresent() && target.upM().isPresent();
    if (!areKnown || now.evasionClimb() == 0.0 || now.verticalClearance() == 0.0) {
      return Optional.empty();
    }
    double top = highestDownM(plane, world, now);
    double bottom = Double.POSITIVE_INFINITY;
    for (PlanarShape corridor : world.corridors()) {
      bottom = Math.min(bottom, corridor.bottomDownM());
    }
    double below = groundDownM(plane, at.x(), at.y(), spot);
    double clearance = now.verticalClearance();
    double keptM = spot.isPresent() ? LOW_M : clearance;
    double groundM = Double.isNaN(below) ? clearance : Math.min(keptM, below - at.z());
    // Beyond the map there may be a hill: do not descend.
    double beyond = Double.isNaN(below) ? Double.NaN : at.z() + groundM;
    DoubleBinaryOperator groundOrBeyond =
        (north, east) -> {
          double mapped = groundDownM(plane, north, east, spot);
          return Double.isNaN(mapped) ? beyond : mapped;
        };
    double atGoal = groundDownM(plane, at.x() + toGoal.x(), at.y() + toGoal.y(), spot);
    double goalM = Double.isNaN(atGoal) ? clearance : atGoal - at.z() - toGoal.z();
    double levelM = Math.min(groundM, Math.max(LOW_M, goalM));
    bottom = Double.isNaN(below) ? bottom : Math.min(bottom, below - groundM);
    OptionalDouble floor = fence.map(FenceState::lowest).orElse(OptionalDouble.empty());
    if (floor.isPresent() && bottom < Double.POSITIVE_INFINITY) { // otherwise the ground is unknown
      bottom = Math.min(bottom, downM(plane, floor.getAsDouble()) - clearance);
    }
    return Optional.of(
        new VerticalRoom(
            at.z(),
            at.z() + toGoal.z(),
            now.evasionClimb(),
            clearance,
            groundM,
            levelM,
            now.body(false).circleM() + now.clearance(),
            top,
            bottom,
            world.shapesElsewhere(),
            groundOrBeyond,
            direction));
  }

  /**
   * Down coordinate of the highest altitude to which the corridors and the fence let the vehicle
   * climb [m]; −∞ without a limit.
   */
  double highestDownM(PlanningPlane plane, SeenWorld world, AvoidanceVariables now) {
    double top = Double.NEGATIVE_INFINITY;
    for (PlanarShape corridor : world.corridors()) {
      top = Math.max(top, corridor.topDownM());
    }
    OptionalDouble ceiling = fence.map(FenceState::highest).orElse(OptionalDouble.empty());
    return ceiling.isEmpty()
        ? top
        : Math.max(top, downM(plane, ceiling.getAsDouble()) + now.verticalClearance());
  }

  /**
   * Part of a climb or descent that leaves room to level off inside the fence in force: the Safety
   * Manager acts when an aircraft climbs too fast towards its ceiling.
   *
   * @param downM altitude of the vehicle, down coordinate on the plane [m]
   * @param downMps its velocity [m/s]
   * @param wayM wanted climb or descent, down [m]
   */
  double inside(PlanningPlane plane, double downM, double downMps, double wayM) {
    OptionalDouble limit =
        fence
            .map(wayM < 0.0 ? FenceState::highest : FenceState::lowest)
            .orElse(OptionalDouble.empty());
    double sign = Math.signum(wayM);
    double leftM = limit.isEmpty() ? 0.0 : sign * (downM(plane, limit.getAsDouble()) - downM);
    if (leftM <= 0.0) {
      return wayM; // without a limit, or already beyond it
    }
    double mps = Math.max(0.0, sign * downMps);
    double levelsM = LEVELS_SHARE * (mps * REACTION_S + mps * mps / (2.0 * LEVELS_MPS2));
    return sign * Math.min(sign * wayM, Math.max(0.0, leftM - levelsM));
  }

  private double groundDownM(PlanningPlane plane, double north, double east, Optional<Point> spot) {
    if (spot.isPresent()
        && Math.hypot(north - spot.get().x(), east - spot.get().y()) < KnownGround.REACH_M) {
      return spot.get().z();
    }
    return ground.downM(plane, north, east);
  }

  /** Down coordinate of an altitude: above sea level, or up in the local frames [m]. */
  private static double downM(PlanningPlane plane, double altitudeM) {
    return plane.onEarth() ? plane.point(0.0, 0.0, 0.0).z() - altitudeM : -altitudeM;
  }

  /** Stores the direction and reports the start of an evasion. */
  void chosen(ArcChoice choice, Point at, long micros) {
    boolean isOver = micros - lastMicros > LASTS_MICROS;
    if (Double.isNaN(choice.toDownM())) {
      direction = isOver ? 0 : direction;
      return;
    }
    double upM = at.z() - choice.toDownM();
    boolean isLevel = Math.abs(upM) < SAME_M;
    int now = isLevel ? direction : upM > 0.0 ? 1 : -1;
    if (isOver || now != direction) {
      String how = isLevel ? "keeping the altitude" : upM > 0.0 ? "climbing" : "descending";
      say.accept("traffic in the way: " + how, false);
    }
    direction = now;
    lastMicros = micros;
  }
}
