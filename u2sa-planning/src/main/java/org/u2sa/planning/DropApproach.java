package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.payload.RunIn;

/**
 * Way to a straight pass over a drop: around obstacles and traffic and, for an aeroplane, such that
 * it can turn back behind the drop.
 */
final class DropApproach {
  private static final double NEAR = 0.5; // in reaches of a turn: too near to turn to the drop

  private final Detour detour;
  private Optional<RunIn> runIn = Optional.empty(); // on the way to the next pass
  private boolean isChosen; // the pass, such that there is room behind it
  private int unreached; // beginnings of passes to which no way was found

  DropApproach(Detour detour) {
    this.detour = detour;
  }

  void begin() {
    runIn = Optional.empty();
    isChosen = false;
    unreached = 0;
    detour.begin();
  }

  /**
   * The next step; empty if the vehicle can move straight to the drop.
   *
   * @param aim where the pass leads to, at its altitude
   * @param isOnPass whether the vehicle already moves straight to it
   */
  Optional<Plan> step(
      PayloadDrop goal, Vehicle vehicle, StateInformation state, Place aim, boolean isOnPass) {
    if (runIn.isPresent()) {
      return Optional.of(toRunIn(goal, vehicle, state, aim));
    }
    double reachM = detour.turnReachM(vehicle);
    boolean turns = reachM > 0.0 && !isOnPass;
    if (turns && !isChosen && hasNoRoomBehind(vehicle, state, aim, reachM)) {
      return Optional.of(away(goal, vehicle, state, aim, reachM));
    }
    Optional<Plan> around =
        detour.ifHindered(vehicle, state, wanted(goal, aim, OptionalDouble.empty()), isOnPass);
    Point to = vehicle.nedOf(aim);
    boolean isNear = Math.hypot(to.x(), to.y()) < NEAR * reachM;
    return around.isPresent() && turns && isNear
        ? Optional.of(away(goal, vehicle, state, aim, reachM))
        : around;
  }

  /** Whether a straight pass from here leaves no room behind it to turn back. */
  private boolean hasNoRoomBehind(
      Vehicle vehicle, StateInformation state, Place aim, double reachM) {
    Point to = vehicle.nedOf(aim);
    double beyond = reachM / Math.max(1.0, Math.hypot(to.x(), to.y()));
    return detour.isClosed(vehicle, state, aim, aim.moved(beyond * to.x(), beyond * to.y()));
  }

  /** Moves to where a pass with enough room begins. */
  private Plan away(
      PayloadDrop goal, Vehicle vehicle, StateInformation state, Place aim, double reachM) {
    Point to = vehicle.nedOf(aim);
    runIn =
        RunIn.to(
            aim,
            Math.atan2(to.y(), to.x()),
            reachM,
            place -> detour.isClosed(vehicle, state, aim, place),
            unreached);
    if (runIn.isEmpty()) {
      String reason =
          String.format(
              Locale.ROOT,
              "given up: no straight pass of %.0f m before and behind it keeps off high ground and "
                  + "inside the corridors",
              reachM);
      return new Plan(List.of(), Plan.Progress.ABANDONED, reason);
    }
    detour.begin();
    return toRunIn(goal, vehicle, state, aim);
  }

  private Plan toRunIn(PayloadDrop goal, Vehicle vehicle, StateInformation state, Place aim) {
    RunIn way = runIn.orElseThrow();
    OptionalDouble course = OptionalDouble.of(way.courseRad());
    Plan plan = detour.step(vehicle, state, wanted(goal, way.begin(), course));
    if (way.isReached(vehicle)) {
      begin();
      isChosen = true;
    } else if (plan.progress() == Plan.Progress.ABANDONED) {
      unreached++;
      return away(goal, vehicle, state, aim, way.lengthM());
    }
    return plan;
  }

  private static Avoidance.Wanted wanted(PayloadDrop goal, Place target, OptionalDouble course) {
    return new Avoidance.Wanted(
        goal.uid(), target, goal.horizontalThreshold(), course, goal.speed());
  }
}
