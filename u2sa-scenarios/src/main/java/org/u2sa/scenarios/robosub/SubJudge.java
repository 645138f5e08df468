package org.u2sa.scenarios.robosub;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import org.u2sa.scenarios.run.TruthObserver;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** Scores a run by the truth: gate, buoys in order, and surfacing inside the ring. */
final class SubJudge implements TruthObserver.Scorer {
  /** Time limit of a run [s]. */
  static final double RUN_S = 600.0;

  private static final double STOPPED_S = 30.0; // time to rise after a failsafe
  private static final double SURFACE_M = 0.3; // depth at which the hull breaks the surface
  private static final double GATE_HALF_M = 0.6; // half the height of its poles
  private static final String BUOY = "buoy";

  private final SubCourse course;
  private final RunningVehicle run;
  private final Path directory;
  private final LocalPlane plane = new LocalPlane(SubCourse.ORIGIN);
  private final List<String> log = new ArrayList<>();
  private final SubEvents events = new SubEvents();
  private double stoppedS = Double.POSITIVE_INFINITY; // when a failsafe stopped the thrusters
  private Point before; // null at the start
  private double travelledM;
  private double positionErrorM = Double.NaN; // of the newest state
  private double worstDepthErrorM = Double.NaN;
  private boolean isGatePassed;
  private boolean isWrongSide;
  private volatile boolean over;

  SubJudge(SubCourse course, RunningVehicle run, Path directory) {
    this.course = course;
    this.run = run;
    this.directory = directory;
  }

  @Override
  public void see(VehicleTruth truth) {
    Point at = truth.position();
    Point now = Point.of(at.y(), at.x(), -at.z());
    if (before != null) {
      travelledM += now.minus(before).distance();
      look(before, now, truth.timeS());
    }
    before = now;
    stoppedS = events.isStopped() ? Math.min(stoppedS, truth.timeS()) : Double.POSITIVE_INFINITY;
    over |= truth.timeS() >= Math.min(RUN_S, stoppedS + STOPPED_S);
  }

  private void look(Point from, Point to, double timeS) {
    if (isGatePassed || isWrongSide) {
      return;
    }
    Point across = course.right().minus(course.left());
    double length = Math.hypot(across.x(), across.y());
    Point unit = across.times(1.0 / length);
    double was = along(from, unit);
    double is = along(to, unit);
    double aside =
        (to.x() - course.middle().x()) * unit.x() + (to.y() - course.middle().y()) * unit.y();
    boolean isInside =
        Math.abs(aside) < length / 2.0 && Math.abs(to.z() - course.middle().z()) < GATE_HALF_M;
    if (was < 0.0 && is >= 0.0 && isInside) {
      isGatePassed = course.isLeft() == aside < 0.0;
      isWrongSide = !isGatePassed;
      say(timeS, String.format(Locale.ROOT, "gate passed, %+.2f m from its divider", aside));
    }
  }

  /** Distance beyond the plane of the gate. */
  private double along(Point at, Point across) {
    return (at.x() - course.middle().x()) * across.y()
        - (at.y() - course.middle().y()) * across.x();
  }

  private void say(double timeS, String line) {
    log.add(String.format(Locale.ROOT, "%6.1f s  %s", timeS, line));
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
    List<String> bumped = new ArrayList<>();
    int contacts = 0;
    for (var contact : run.contacts()) {
      String uid = contact.object().uid();
      say(contact.timeS(), "touches " + uid);
      if (!uid.endsWith(BUOY)) {
        contacts++;
      } else if (!bumped.contains(uid)) {
        bumped.add(uid);
      }
    }
    List<String> wanted =
        course.colours().stream().map(colour -> SubCourse.type(colour, BUOY)).toList();
    int inOrder = 0;
    while (inOrder < Math.min(bumped.size(), wanted.size())
        && bumped.get(inOrder).equals(wanted.get(inOrder))) {
      inOrder++;
    }
    double offM =
        before == null
            ? Double.POSITIVE_INFINITY
            : Math.hypot(before.x() - course.ring().x(), before.y() - course.ring().y());
    boolean isInRing = before != null && before.z() < SURFACE_M && offM < SubCourse.RING_M;
    List<String> violations = new ArrayList<>();
    if (!isGatePassed) {
      violations.add(isWrongSide ? "gate: passed on the wrong side" : "gate: not passed");
    }
    if (inOrder < wanted.size()) {
      violations.add("buoys: expected " + wanted + ", bumped " + bumped);
    }
    if (!isInRing) {
      violations.add(String.format(Locale.ROOT, "ring: ended %.2f m from its middle", offM));
    }
    violations.addAll(events.troubles());
    ReportFile.writeText(
        directory.resolve("judge.log"), out -> out.write(String.join("\n", log) + "\n"));
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put(RunOutcome.GOALS_WITHOUT_PLACE, wanted.size() + 3);
    counts.put("gatesPassed", isGatePassed ? 1 : 0);
    counts.put("buoysBumpedInOrder", inOrder);
    counts.put("surfacedInRing", isInRing ? 1 : 0);
    counts.putAll(events.counts());
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("travelledMetres", travelledM);
    if (Double.isFinite(offM)) {
      figures.put("metresFromRingsMiddle", offM);
    }
    if (!Double.isNaN(positionErrorM)) {
      figures.put("finalPositionErrorMetres", positionErrorM);
    }
    if (!Double.isNaN(worstDepthErrorM)) {
      figures.put("worstDepthErrorMetres", worstDepthErrorM);
    }
    return new RunOutcome(contacts, false, violations, counts, figures);
  }
}
