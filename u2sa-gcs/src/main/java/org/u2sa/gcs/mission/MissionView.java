package org.u2sa.gcs.mission;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;

/** A mission as shown to operators. */
public final class MissionView {
  private final MissionReport report;
  private final Optional<StateInformation> state;

  /**
   * @param state vehicle state; empty if unknown
   */
  public MissionView(MissionReport report, Optional<StateInformation> state) {
    this.report = report;
    this.state = state;
  }

  /** The Mission Manager's report. */
  public MissionReport report() {
    return report;
  }

  /** Status of a goal, in words. */
  public String status(GoalInformation goal) {
    if (report.current().contains(goal.uid())) {
      return "current";
    }
    if (goal.result().isPresent()) {
      return words(goal.result().get());
    }
    return report.upcoming().contains(goal.uid()) ? "next" : "open";
  }

  static String words(GoalResult result) {
    return result.name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /** Time of arrival [s since the start of the mission]; empty before arrival. */
  public OptionalDouble arrivedS(GoalInformation goal) {
    return goal.arrivedAt().isPresent() && report.began().isPresent()
        ? OptionalDouble.of(
            Clock.seconds(goal.arrivedAt().getAsLong() - report.began().getAsLong()))
        : OptionalDouble.empty();
  }

  /** Horizontal distance to a goal [m]; empty if it has no position or the distance is unknown. */
  public OptionalDouble distanceM(GoalInformation goal) {
    if (!(goal instanceof Waypoint waypoint)
        || state.isEmpty()
        || waypoint.x().isEmpty()
        || waypoint.y().isEmpty()) {
      return OptionalDouble.empty();
    }
    try {
      StateInformation place =
          new StateInformation()
              .referenceFrame(waypoint.referenceFrame())
              .x(waypoint.x().getAsDouble())
              .y(waypoint.y().getAsDouble());
      return OptionalDouble.of(distanceM(place, state.get()));
    } catch (IllegalArgumentException e) {
      return OptionalDouble.empty(); // no conversion between the frames
    }
  }

  private static double distanceM(StateInformation place, StateInformation vehicle) {
    if (place.referenceFrame().isEarth()) {
      return onEarth(vehicle).distanceM(onEarth(place));
    }
    StateInformation there = vehicle.in(place.referenceFrame());
    return Math.hypot(
        there.x().orElseThrow() - place.x().orElseThrow(),
        there.y().orElseThrow() - place.y().orElseThrow());
  }

  private static Geodetic onEarth(StateInformation place) {
    StateInformation global = place.in(ReferenceFrame.GLOBAL);
    if (global.x().isEmpty() || global.y().isEmpty()) {
      throw new IllegalArgumentException("no position");
    }
    return new Geodetic(global.x().getAsDouble(), global.y().getAsDouble(), 0.0);
  }

  /** Number of times a goal was finished. */
  public long timesFinished(int index) {
    return index < report.finished().size() ? Math.round(report.finished().get(index)) : 0;
  }

  /** Names of the followers of a goal, by condition: "", "if failed", "2 times". */
  public Map<String, List<String>> next(GoalInformation goal) {
    Map<String, List<String>> next = new LinkedHashMap<>();
    List<String> usual = new ArrayList<>(goal.next());
    int place = report.sequence().indexOf(goal.uid());
    if (usual.isEmpty() && place >= 0 && place + 1 < report.sequence().size()) {
      usual.add(report.sequence().get(place + 1));
    }
    goal.repeatFrom()
        .ifPresent(from -> next.put(times(goal.repeatTimes().orElse(1)), List.of(from)));
    if (!usual.isEmpty()) {
      next.put("", usual);
    }
    for (GoalResult result : List.of(GoalResult.DONE, GoalResult.FAILED, GoalResult.TIMED_OUT)) {
      goal.nextIf(result).ifPresent(names -> next.put("if " + words(result), names));
    }
    return next;
  }

  private static String times(long times) {
    return times == 1 ? "once" : times + " times";
  }
}
