package org.u2sa.scenarios.robosub.course;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.trials.run.TruthObserver;

/** Scores a run by ground truth: judges of tasks, contacts, and the estimate's errors. */
public final class SubJudge implements TruthObserver.Scorer {
  /** Number of markers, and of torpedoes, that a vehicle may carry. */
  static final int CARRIED = 2;

  /** Time limit of a run [s]. */
  public static final double RUN_S = 600.0;

  private static final List<String> RELEASES = List.of("DROPPER", "LAUNCHER");
  private static final double OPEN_PERCENT = 100.0;

  private static final double DONE_S = 0.5; // time from the last goal's report to the end
  private static final double STOPPED_S = 30.0; // time to rise after a failsafe

  private final SubCourse course;
  private final List<SubTaskJudge> judges;
  private final RunningVehicle run;
  private final Path directory;
  private final ToDoubleFunction<String> switchPercent;
  private final Set<String> released = new TreeSet<>(); // releases currently open
  private final LocalPlane plane = new LocalPlane(SubCourse.ORIGIN);
  private final List<String> log = new ArrayList<>();
  private final SubEvents events = new SubEvents();
  private double doneS = Double.POSITIVE_INFINITY; // time at which the last goal was completed
  private double stoppedS = Double.POSITIVE_INFINITY; // when a failsafe stopped the thrusters
  private Point before; // null at the start
  private double travelledM;
  private double positionErrorM = Double.NaN; // error of the newest state
  private double worstDepthErrorM = Double.NaN;
  private volatile boolean over;

  /**
   * @param switchPercent current level of a release [%], by name
   */
  public SubJudge(
      SubCourse course,
      RunningVehicle run,
      ToDoubleFunction<String> switchPercent,
      Path directory) {
    this.course = course;
    this.run = run;
    this.switchPercent = switchPercent;
    this.directory = directory;
    judges = course.tasks().stream().map(CourseTask::judge).collect(Collectors.toList());
  }

  @Override
  public void see(VehicleTruth truth) {
    Point at = truth.position();
    Point now = Point.of(at.y(), at.x(), -at.z());
    if (before != null) {
      travelledM += now.minus(before).distance();
      judges.forEach(judge -> say(truth.timeS(), judge.moved(before, now)));
    }
    before = now;
    RELEASES.forEach(name -> release(name, truth));
    stoppedS = events.isStopped() ? Math.min(stoppedS, truth.timeS()) : Double.POSITIVE_INFINITY;
    doneS = events.isComplete(course) ? Math.min(doneS, truth.timeS()) : doneS;
    double endS = Math.min(doneS + DONE_S, stoppedS + STOPPED_S);
    over |= truth.timeS() >= Math.min(RUN_S, endS);
  }

  private void release(String name, VehicleTruth truth) {
    if (switchPercent.applyAsDouble(name) < OPEN_PERCENT) {
      released.remove(name);
    } else if (released.add(name)) {
      judges.forEach(judge -> say(truth.timeS(), judge.released(name, truth)));
    }
  }

  private void say(double timeS, Optional<String> line) {
    line.ifPresent(text -> log.add(String.format(Locale.ROOT, "%6.1f s  %s", timeS, text)));
  }

  @Override
  public List<Channel<?>> listensTo() {
    List<Channel<?>> channels = new ArrayList<>(events.listensTo());
    channels.add(Channels.STATE);
    return channels;
  }

  @Override
  public void reported(GoalInformation report) {
    events.reported(report);
  }

  @Override
  public boolean heard(U2SAData data) {
    if (!(data instanceof StateInformation state)) {
      return events.heard(data);
    }
    if (before != null && state.referenceFrame().isEarth()) {
      StateInformation global = state.in(ReferenceFrame.GLOBAL);
      if (global.x().isPresent() && global.y().isPresent()) {
        double altitude = global.z().orElse(0.0);
        Point said =
            plane.point(new Geodetic(global.x().getAsDouble(), global.y().getAsDouble(), altitude));
        positionErrorM = Math.hypot(said.x() - before.y(), said.y() - before.x());
        if (global.z().isPresent()) {
          worstDepthErrorM =
              Math.max(
                  Double.isNaN(worstDepthErrorM) ? 0.0 : worstDepthErrorM,
                  Math.abs(said.z() + before.z()));
        }
      }
    }
    return true;
  }

  @Override
  public boolean isOver() {
    return over;
  }

  @Override
  public String phase(boolean moves) {
    return moves ? "DIVES" : "STANDS";
  }

  @Override
  public RunOutcome outcome() {
    int contacts = 0;
    for (var contact : run.contacts()) {
      String uid = contact.object().uid();
      say(contact.timeS(), Optional.of("touches " + uid));
      contacts += SubObjects.isTouchable(contact.object()) ? 0 : 1;
      judges.forEach(judge -> judge.touched(uid));
    }
    Collections.sort(log);
    ReportFile.writeText(
        directory.resolve("judge.log"), out -> out.write(String.join("\n", log) + "\n"));
    List<String> violations = new ArrayList<>();
    Map<String, Integer> counts = new LinkedHashMap<>();
    Map<String, Double> figures = new LinkedHashMap<>();
    counts.put(
        RunOutcome.GOALS_WITHOUT_PLACE,
        course.tasks().stream().mapToInt(task -> task.goals().size()).sum());
    counts.put(RunOutcome.TASKS, judges.size());
    counts.put(
        RunOutcome.TASKS_DONE,
        (int) judges.stream().filter(judge -> judge.violation().isEmpty()).count());
    for (SubTaskJudge judge : judges) {
      judge.violation().ifPresent(violations::add);
      counts.putAll(judge.counts());
      figures.putAll(judge.figures());
    }
    violations.addAll(events.troubles());
    counts.putAll(events.counts());
    figures.put("travelledMetres", travelledM);
    figures.put("finalPositionErrorMetres", positionErrorM);
    figures.put("worstDepthErrorMetres", worstDepthErrorM);
    figures.values().removeIf(figure -> !Double.isFinite(figure));
    return new RunOutcome(contacts, false, violations, counts, figures);
  }
}
