package org.u2sa.trials.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.core.safety.Fence;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Track;
import org.u2sa.report.score.TrackSample;

/**
 * The record of a run, for scoring and display. Confined to the observer's thread, except methods
 * documented as thread-safe.
 */
public final class RunRecord {
  private static final long NOT_YET = -1;
  private static final String THRESHOLD = "Threshold>"; // in the XML of orders

  private final List<String> names;
  private final MovedPlan plan;
  private final Track track = new Track();
  private final Geodetic origin; // of the local frames
  private final Consumer<TrackSample> screen;
  private final Set<String> leftOut = new HashSet<>();
  private final Set<String> done = new HashSet<>();
  private final Set<String> landings = new LinkedHashSet<>(); // of the plan, once current
  private List<String> current = List.of(); // goals
  private double currentAfterS = Double.NEGATIVE_INFINITY; // last sample before they were current
  private double lastS = Double.NEGATIVE_INFINITY;
  private final List<List<String>> pursued = new ArrayList<>(); // goals, one after the other
  private boolean repeats; // whether a goal leads back
  private boolean chosen; // whether one of the current goals was completed
  private int leg = -1;
  private boolean begun;
  private boolean
      onLine; // whether the vehicle came from the waypoint at which the leg begins, and is on its
  // way
  private boolean isStation; // whether the target is one
  private boolean seen = true; // whether there is a sample with the current target
  private long startMicros = NOT_YET;
  private volatile boolean missionOver;
  private final OrderedGoals ordered = new OrderedGoals();
  // goals that an operator's orders name, and whether an order changes thresholds
  private final Map<String, Boolean> updated = new HashMap<>();
  private volatile long readings; // single writer
  private Optional<FenceRecord> fence = Optional.empty();

  /**
   * @param origin of the local frames
   * @param screen receives every sample, on the observer's thread
   */
  public RunRecord(RunPlan plan, Geodetic origin, Consumer<TrackSample> screen) {
    this.screen = screen;
    names = plan.waypoints().stream().map(waypoint -> waypoint.name()).toList();
    this.plan = new MovedPlan(plan, origin);
    this.origin = origin;
  }

  /**
   * Judges the following samples by a fence; call before the first.
   *
   * @param inForce the fence in force now; empty if none. Thread-safe
   */
  void within(Supplier<Optional<Fence>> inForce) {
    fence = Optional.of(new FenceRecord(inForce, origin));
  }

  /** Processes goals, goal reports and {@link Channels#MISSION}; false for other messages. */
  public boolean received(U2SAData data) {
    if (data instanceof MissionOrder order) {
      ordered(order);
      return true;
    }
    if (data instanceof MissionOrderResult result) {
      ordered.answered(result, done).ifPresent(this::replaceBy);
      return true;
    }
    if (Channels.MISSION.carries(data)) {
      return true;
    }
    if (data instanceof GoalList goals) {
      follow(goals);
    } else if (data instanceof GoalInformation report) {
      reported(report);
    } else {
      return false;
    }
    return true;
  }

  private void ordered(MissionOrder order) {
    boolean replaces = order.action() == MissionAction.REPLACE;
    if (replaces || order.action() == MissionAction.UPDATE) {
      String goals = order.goals().orElse("");
      boolean changesThresholds = replaces || goals.contains(THRESHOLD);
      names.stream()
          .filter(goals::contains)
          .forEach(name -> updated.merge(name, changesThresholds, Boolean::logicalOr));
    }
    ordered.see(order);
  }

  private void replaceBy(Set<String> goals) {
    names.stream()
        .filter(name -> !goals.contains(name) && !done.contains(name))
        .forEach(leftOut::add);
    done.removeAll(goals); // those of the new mission are still to be pursued
  }

  /**
   * Goals to complete: those of the planned mission with inserted ones, or of a mission that
   * replaced it with those completed before; call like {@link #track}.
   *
   * @param planned goals of the mission at the start
   */
  Set<String> goals(Set<String> planned) {
    return ordered.goals(planned);
  }

  /**
   * Violations by goals that were neither completed nor left out; call like {@link #track}.
   *
   * @param required goals of the mission at the start that have to be completed unless an operator
   *     replaced them; those that operators added have to be in any case
   */
  public List<String> incomplete(Set<String> required) {
    return goals(required).stream()
        .filter(goal -> !done.contains(goal) && !leftOut.contains(goal))
        .map(goal -> "goal \"" + goal + "\" was not completed")
        .toList();
  }

  /** A report names the goal that the planner pursued among several current ones. */
  private void reported(GoalInformation report) {
    boolean isCurrent = current.contains(report.uid());
    if (report.completed()) {
      done.add(report.uid());
      chosen |= isCurrent;
    }
    int at = names.indexOf(report.uid());
    if (isCurrent && at >= 0 && at != leg) {
      leg = at;
      onLine = false;
      track.pursued(currentAfterS, leg);
    }
  }

  private void become(List<String> next) {
    if (chosen) {
      current.stream().filter(goal -> !next.contains(goal)).forEach(leftOut::add);
    }
    leftOut.removeAll(next);
    leftOut.removeAll(done);
    current = next;
    pursued.add(next);
    currentAfterS = lastS;
    chosen = false;
  }

  private void follow(GoalList goals) {
    seen = false;
    List<String> uids = goals.goals().stream().map(GoalInformation::uid).toList();
    repeats |= goals.goals().stream().anyMatch(goal -> goal.repeatFrom().isPresent());
    if (!uids.equals(current)) {
      become(uids);
    }
    missionOver = goals.goals().isEmpty();
    int next = goals.goals().isEmpty() ? names.size() : names.indexOf(goals.goals().get(0).uid());
    goals.goals().forEach(this::followMoved);
    if (next != leg) {
      onLine = next == leg + 1 && (leg >= 0 || !begun);
    }
    leg = next;
    begun = true;
    goals.goals().stream()
        .filter(goal -> goal instanceof Landing && names.contains(goal.uid()))
        .forEach(goal -> landings.add(goal.uid()));
    isStation = goals.goals().stream().limit(1).anyMatch(Station.class::isInstance);
  }

  private void followMoved(GoalInformation goal) {
    int at = names.indexOf(goal.uid());
    // without an order, a goal of this name elsewhere is a failsafe's
    if (updated.containsKey(goal.uid())
        && goal instanceof Waypoint waypoint
        && plan.follow(waypoint, at, updated.get(goal.uid()))) {
      track.abandoned(at);
      onLine = false;
    }
  }

  /**
   * The plan, with waypoints where they were moved to and the last fence; call like {@link #track}.
   */
  RunPlan plan() {
    return fence.map(each -> each.fenced(plan.plan())).orElse(plan.plan());
  }

  /** Copy of an outcome with the fence's breaches; call like {@link #track}. */
  RunOutcome counted(RunOutcome outcome) {
    return fence.map(each -> each.counted(outcome)).orElse(outcome);
  }

  /** Waypoints that were moved; call like {@link #track}. */
  Set<String> moved() {
    return plan.moved();
  }

  /** Whether the vehicle is at its station or on the circle around it. */
  private boolean hasArrived(double longitudeDeg, double latitudeDeg) {
    return isStation
        && leg >= 0
        && leg < names.size()
        && plan.plan().distanceM(leg, longitudeDeg, latitudeDeg)
            <= plan.plan().waypoints().get(leg).captureRadiusM();
  }

  /**
   * Whether the target has no {@link #moment} yet. The scorer must be set before a replacement, or
   * the score would miss it.
   */
  boolean isTargetUnseen() {
    return !seen && leg >= 0 && leg < names.size();
  }

  /**
   * Records the vehicle's true state at a time [µs] after the previous one.
   *
   * @param altitudeM above mean sea level [m]
   * @param headingRad clockwise from true north [rad]
   * @param speedMps over ground [m/s]
   */
  public void moment(
      long micros,
      double longitudeDeg,
      double latitudeDeg,
      double altitudeM,
      double headingRad,
      double speedMps,
      String phase,
      Optional<TrackSample.Flight> flight) {
    if (startMicros == NOT_YET) {
      startMicros = micros;
    }
    onLine &= !hasArrived(longitudeDeg, latitudeDeg);
    fence.ifPresent(each -> each.see(longitudeDeg, latitudeDeg));
    TrackSample sample =
        new TrackSample(
            Clock.seconds(micros - startMicros),
            longitudeDeg,
            latitudeDeg,
            altitudeM,
            headingRad,
            speedMps,
            onLine
                ? plan.plan().crossTrackM(leg, longitudeDeg, latitudeDeg)
                : OptionalDouble.empty(),
            leg,
            phase,
            flight);
    track.append(sample);
    lastS = sample.timeS();
    seen = true;
    readings++;
    screen.accept(sample);
  }

  /** All samples; call only after the observer has stopped. */
  Track track() {
    return track;
  }

  /** Current goals not completed because enough others were; call like {@link #track}. */
  Set<String> leftOut() {
    return leftOut;
  }

  /** Landings that were pursued and not completed; call like {@link #track}. */
  public List<String> landingsMissed() {
    return landings.stream().filter(uid -> !done.contains(uid) && !leftOut.contains(uid)).toList();
  }

  /** Whether the Mission Manager has no goal left. Thread-safe. */
  public boolean isMissionOver() {
    return missionOver;
  }

  /** Number of samples. Thread-safe. */
  long readings() {
    return readings;
  }

  /**
   * Goals reported completed; of a mission that repeats goals, without those that it would still
   * pursue; call like {@link #track}.
   *
   * @param planned goals of the mission at the start
   */
  Set<String> completed(Set<String> planned) {
    Set<String> completed = new LinkedHashSet<>(goals(planned));
    completed.retainAll(done);
    completed.removeAll(unrepeated(planned));
    return completed;
  }

  /** Goals that were completed and that the mission would still pursue again; as completed. */
  List<String> unrepeated(Set<String> planned) {
    return repeats ? remaining(goals(planned)).stream().filter(done::contains).toList() : List.of();
  }

  /** The mission's goals that were current last; those of a failsafe leave them as they were. */
  private List<String> remaining(Set<String> own) {
    List<String> remaining = List.of();
    boolean wasOwn = true;
    for (List<String> uids : pursued) {
      boolean isOwn = own.containsAll(uids);
      if (isOwn && (wasOwn || !uids.isEmpty())) {
        remaining = uids;
      }
      wasOwn = isOwn;
    }
    return remaining;
  }
}
