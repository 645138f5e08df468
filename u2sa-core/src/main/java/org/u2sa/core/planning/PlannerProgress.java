package org.u2sa.core.planning;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.GoalList;
import org.u2sa.service.HandOver;

/**
 * How far a planner is in its mission: what another planner goes on from.
 *
 * @param goals the newest list
 * @param goal pursued
 * @param finished reported as finished, and still the newest such
 * @param reportedMicros when [µs of the run's clock]
 * @param holdAt the last place reached or given up
 * @param foreseen UID of the goal that is expected next
 */
record PlannerProgress(
    Optional<GoalList> goals,
    Optional<GoalInformation> goal,
    Optional<GoalInformation> finished,
    long reportedMicros,
    Optional<Place> holdAt,
    String foreseen) {

  void handOver(HandOver state) {
    goals.ifPresent(list -> state.message("GOALS", list));
    goal.ifPresent(pursued -> state.message("GOAL", pursued));
    finished.ifPresent(done -> state.message("FINISHED", done));
    state.number("REPORTED AT", Clock.seconds(reportedMicros));
    holdAt.ifPresent(place -> place.handOver(state, "HOLD AT"));
    state.text("FORESEEN", foreseen);
  }

  static PlannerProgress takenOver(HandOver state) {
    return new PlannerProgress(
        state.message("GOALS", GoalList.class),
        state.message("GOAL", GoalInformation.class),
        state.message("FINISHED", GoalInformation.class),
        Clock.micros(state.number("REPORTED AT").orElse(0.0)),
        Place.takenOver(state, "HOLD AT"),
        state.text("FORESEEN").orElse(""));
  }
}
