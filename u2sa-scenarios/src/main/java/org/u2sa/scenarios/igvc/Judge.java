package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.TruthObserver;

/**
 * Judges a run by the competition's rules and ground truth: no part of the vehicle on a line
 * (including gaps in its paint and the ends of the course) or an obstacle; more than 1 mph on
 * average over the first 44 ft, never more than 5 mph; at most a minute at rest; six minutes in
 * all. A continuous touch counts once. Flags passed on the wrong side are counted but do not fail a
 * run.
 */
final class Judge {
  static final double SLOWEST_MPS = 0.44704; // 1 mph
  static final double FASTEST_MPS = 2.2352; // 5 mph
  static final double TIMED_M = 13.4112; // 44 ft
  static final double REST_S = 60.0;
  static final double RUN_S = 360.0;
  static final double WAYPOINT_M = 2.0;

  private static final double SETTLED_S = 1.0; // shorter interruptions are the same touch

  private final World lines;
  private final World obstacles;
  private final Footprint overPaint;
  private final Footprint body;
  private final FlagSides flags;
  private final double runS;
  private final List<String> log = new ArrayList<>();
  private final List<String> violations = new ArrayList<>();
  private final Map<String, Double> lastTouch = new LinkedHashMap<>();
  private int crossings;
  private int touches;
  private int wrongFlags;
  private double beganS = Double.NaN;
  private double lastS;
  private Point last;
  private double distanceM;
  private double restS;
  private double stoppedS;
  private boolean timed;
  private boolean tooFast;
  private volatile boolean over;

  /**
   * @param frontM distance from the vehicle's reference point to its front [m]
   * @param rearM distance from the reference point to its rear [m]
   * @param runS time limit of the run [s]: {@link #RUN_S}, unless the course is longer than in the
   *     rules
   */
  Judge(Course course, double frontM, double rearM, double widthM, double runS) {
    this.runS = runS;
    World lawn = World.at(new Geodetic(0.0, 0.0, 0.0));
    lines = lawn.with(course.limits());
    obstacles =
        lawn.with(
            course.objects().stream()
                .filter(CourseChecker::isInTheWay)
                .filter(object -> !(object instanceof PolyLine))
                .toList());
    flags = new FlagSides(course);
    double half = 0.5 * Course.LINE_M;
    overPaint = Footprint.rectangle(frontM + half, rearM + half, widthM + 2.0 * half, -1.0, 0.5);
    body = Footprint.rectangle(frontM, rearM, widthM, -1.0, 0.5);
  }

  /** Judges a sample, later than the previous one. */
  void see(VehicleTruth truth) {
    if (over) {
      return;
    }
    Point at = truth.position();
    boolean moves = TruthObserver.moves(truth);
    if (Double.isNaN(beganS) && moves) {
      beganS = truth.timeS();
      say(truth, "sets off");
    }
    if (last != null) {
      double dtS = truth.timeS() - lastS;
      distanceM += Math.hypot(at.x() - last.x(), at.y() - last.y());
      restS = moves || Double.isNaN(beganS) ? 0.0 : restS + dtS;
      stoppedS += moves || Double.isNaN(beganS) ? 0.0 : dtS;
    }
    last = at;
    lastS = truth.timeS();
    Point flat = Point.of(at.x(), at.y(), 0.0);
    for (ObjectDescription line : lines.contacts(overPaint, flat, truth.headingRad())) {
      if (begins(line, truth)) {
        crossings++;
        say(truth, "is on " + line.uid());
      }
    }
    for (ObjectDescription obstacle : obstacles.contacts(body, flat, truth.headingRad())) {
      if (begins(obstacle, truth)) {
        touches++;
        say(truth, "touches " + obstacle.uid());
      }
    }
    for (ObjectDescription flag : flags.wrong(truth)) {
      wrongFlags++;
      say(truth, "has passed " + flag.uid() + " on the wrong side");
    }
    pace(truth);
  }

  /** Whether a touch is new. */
  private boolean begins(ObjectDescription object, VehicleTruth truth) {
    Double before = lastTouch.put(object.uid(), truth.timeS());
    return before == null || truth.timeS() - before > SETTLED_S;
  }

  private void pace(VehicleTruth truth) {
    if (Double.isNaN(beganS)) {
      return;
    }
    double goneS = truth.timeS() - beganS;
    if (!timed && distanceM >= TIMED_M) {
      timed = true;
      double mean = distanceM / Math.max(1.0e-9, goneS);
      say(truth, String.format(Locale.ROOT, "passes 44 ft at %.2f m/s on average", mean));
      if (mean <= SLOWEST_MPS) {
        end(truth, String.format(Locale.ROOT, "too slow over the first 44 ft: %.2f m/s", mean));
      }
    }
    if (truth.speedMps() > FASTEST_MPS && !tooFast) {
      tooFast = true;
      violation(truth, String.format(Locale.ROOT, "faster than 5 mph: %.2f m/s", truth.speedMps()));
    }
    if (restS > REST_S) {
      end(truth, "stood still for more than a minute");
    } else if (goneS > runS) {
      end(truth, String.format(Locale.ROOT, "the %.0f minutes are over", runS / 60.0));
    }
  }

  private void violation(VehicleTruth truth, String what) {
    say(truth, what);
    violations.add(String.format(Locale.ROOT, "%.1f s: %s", truth.timeS(), what));
  }

  private void end(VehicleTruth truth, String why) {
    violation(truth, why);
    say(truth, "end of the run");
    over = true;
  }

  private void say(VehicleTruth truth, String what) {
    Point at = truth.position();
    log.add(
        String.format(
            Locale.ROOT,
            "%6.1f s  %6.1f m  east %6.2f m, north %6.2f m: %s",
            truth.timeS(),
            distanceM,
            at.x(),
            at.y(),
            what));
  }

  /** Whether the run has ended by the rules. Thread-safe. */
  boolean isOver() {
    return over;
  }

  /** Events, one line each. */
  List<String> log() {
    return List.copyOf(log);
  }

  RunOutcome outcome() {
    List<String> all = new ArrayList<>(violations);
    if (crossings > 0) {
      all.add(crossings + (crossings == 1 ? " line crossing" : " line crossings"));
    }
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put("lineCrossings", crossings);
    counts.put("touches", touches);
    counts.put("flagsOnWrongSide", wrongFlags);
    Map<String, Double> figures = new LinkedHashMap<>();
    double goneS = Double.isNaN(beganS) ? 0.0 : lastS - beganS;
    figures.put("averageSpeedMps", goneS > 0.0 ? distanceM / goneS : 0.0);
    figures.put("stoppedSeconds", stoppedS);
    figures.put("distanceM", distanceM);
    return new RunOutcome(touches, false, all, counts, figures);
  }
}
