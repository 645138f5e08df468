package org.u2sa.scenarios.roboboat;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/**
 * {@link PressButton}: locates the button beside the buoy from the station, runs into it bow first,
 * and backs off.
 */
final class PressButtonState extends StationTaskState {
  private static final double BESIDE_M = 1.2; // maximum distance from the button to its buoy
  private static final double PRESSED_M = 0.55; // from the boat's centre, inside the bow
  private static final double BEAM_M = 0.5; // beside the boat's centre
  private static final double PRESS_MPS = 0.8;
  private static final double BACK_MPS = 1.6;
  private static final double OFF_M = 3.5; // distance from the button after backing off
  private static final double BESIDE_BOW_RAD = Math.toRadians(70.0); // the button was missed
  private static final double GIVE_UP_S = 45.0;

  private enum Phase {
    LOOK,
    PRESS,
    BACK_OFF
  }

  private Phase phase = Phase.LOOK;
  private Optional<Point> button = Optional.empty(); // on the planner's plane
  private boolean isPressed;

  PressButtonState(PlannerView surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return PressButton.class;
  }

  @Override
  void begin(BoatTask task) {
    phase = Phase.LOOK;
    button = Optional.empty();
    isPressed = false;
  }

  @Override
  boolean isFree() {
    return phase != Phase.LOOK;
  }

  @Override
  Plan work(BoatTask task, Pursuit pursuit, double sinceS) {
    StateInformation state = pursuit.state();
    if (phase != Phase.BACK_OFF) {
      button = find(task, state).or(() -> button);
    }
    if (button.isEmpty()) {
      return sinceS > GIVE_UP_S ? givenUp("saw no button beside a buoy") : lookOut(task, state);
    }
    Point here = surroundings.here(state);
    double away = here.flatDistanceTo(button.get());
    double bearing = Math.atan2(button.get().y() - here.y(), button.get().x() - here.x());
    double off = Math.IEEEremainder(bearing - state.psi().orElseThrow(), 2.0 * Math.PI);
    if (phase == Phase.LOOK) {
      phase = Phase.PRESS;
    }
    if (phase == Phase.PRESS && away < PRESSED_M + BEAM_M && Math.abs(off) > BESIDE_BOW_RAD) {
      phase = Phase.BACK_OFF; // missed: try again
    } else if (phase == Phase.PRESS && away < PRESSED_M) {
      isPressed = true;
      phase = Phase.BACK_OFF;
    }
    if (phase == Phase.BACK_OFF) {
      return backOff(task, state, away);
    }
    Point aim = TaskSite.at(button.get(), bearing, 1.0, 0.0);
    return Plan.underWay(List.of(surroundings.straight(state, aim).speed(PRESS_MPS)));
  }

  private Plan backOff(BoatTask task, StateInformation state, double awayM) {
    if (awayM < OFF_M) {
      return back(task, state, BACK_MPS);
    }
    if (isPressed) {
      return new Plan(List.of(), Plan.Progress.COMPLETED, "pressed");
    }
    phase = Phase.LOOK;
    return Plan.underWay(List.of());
  }

  /** The button nearest to the buoy. */
  private Optional<Point> find(BoatTask task, StateInformation state) {
    if (task.objectTypes().size() != 2) {
      return Optional.empty();
    }
    return nearest(task.objectTypes().get(1), station(task, state), task, state)
        .map(buoy -> surroundings.centre(buoy, state))
        .flatMap(
            buoy ->
                nearest(task.objectTypes().get(0), buoy, task, state)
                    .map(each -> surroundings.centre(each, state))
                    .filter(each -> each.flatDistanceTo(buoy) < BESIDE_M));
  }
}
