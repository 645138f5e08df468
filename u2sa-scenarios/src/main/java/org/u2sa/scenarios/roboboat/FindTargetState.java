package org.u2sa.scenarios.roboboat;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/** {@link FindTarget}: observes the target from the station until its position has settled. */
final class FindTargetState extends StationTaskState {
  private static final double LOOK_S = 8.0; // time in view, while the world model averages
  private static final double GIVE_UP_S = 45.0;

  private long seenMicros; // first time; Long.MIN_VALUE: not yet

  FindTargetState(PlannerView surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return FindTarget.class;
  }

  @Override
  void begin(BoatTask task) {
    seenMicros = Long.MIN_VALUE;
  }

  @Override
  Plan work(BoatTask task, Pursuit pursuit, double sinceS) {
    StateInformation state = pursuit.state();
    Optional<ObjectDescription> target =
        task.objectTypes().stream()
            .findFirst()
            .flatMap(type -> nearest(type, station(task, state), task, state));
    if (target.isEmpty()) {
      return sinceS > GIVE_UP_S
          ? givenUp("no " + task.objectTypes() + " was seen")
          : lookOut(task, state);
    }
    if (seenMicros == Long.MIN_VALUE) {
      seenMicros = micros(state);
    }
    if (Clock.seconds(micros(state) - seenMicros) < LOOK_S) {
      return lookOut(task, state);
    }
    Point found = target.get().in(ReferenceFrame.GLOBAL, state).center();
    return new Plan(List.of(), Plan.Progress.COMPLETED, "located")
        .changing(((FindTarget) task).copy().found(found.x(), found.y()));
  }
}
