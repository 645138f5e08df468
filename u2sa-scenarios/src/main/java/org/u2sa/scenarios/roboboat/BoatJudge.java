package org.u2sa.scenarios.roboboat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.scenarios.roboboat.gate.Gate;
import org.u2sa.scenarios.roboboat.subvehicle.QuadrotorOnDeck;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.trials.run.TruthObserver;

/**
 * Scores a run by ground truth: speed gates, and the channel out and back, in order and each in its
 * direction; contacts; the optional tasks; and the time limit.
 */
final class BoatJudge implements TruthObserver.Scorer {
  /** Time limit of a run [s]. */
  static final double RUN_S = 20.0 * 60.0;

  private static final double FIRES_PERCENT = 50.0;
  private static final double HOME_M = 2.5; // the mission's 2 m plus the boat's errors

  private final RunningVehicle run;
  private final DoubleSupplier gunPercent;
  private final Clock clock;
  private final TaskJudge tasks;
  private final QuadrotorOnDeck quadrotor;
  private final Leg speed;
  private final Leg out;
  private final Leg back;
  private final Point home;
  private final Path directory;
  private final List<String> log = new ArrayList<>();
  private Point before; // null at the start
  private boolean isHome; // after the return channel
  private volatile boolean over;

  /** Gates to be passed in order. */
  private static final class Leg {
    private final String name;
    private final List<Gate> gates;
    private int passed;
    private double firstS = Double.NaN;
    private double lastS = Double.NaN;

    Leg(String name, List<Gate> gates) {
      this.name = name;
      this.gates = gates;
    }

    boolean isDone() {
      return passed == gates.size();
    }

    /** Returns a line for the log if the move passes through the next gate, otherwise null. */
    String move(Point from, Point to, double headingRad, double timeS) {
      if (isDone() || !gates.get(passed).isPassed(from, to)) {
        return null;
      }
      Gate gate = gates.get(passed);
      Point way = gate.way();
      double turnRad = headingRad - Math.atan2(way.y(), way.x());
      firstS = passed == 0 ? timeS : firstS;
      lastS = timeS;
      passed++;
      return String.format(
          Locale.ROOT,
          "%s: gate %d of %d passed, %+.2f m from its middle, bow at %+.0f deg",
          name,
          passed,
          gates.size(),
          gate.asideM(to),
          Math.toDegrees(Math.IEEEremainder(turnRad, 2.0 * Math.PI)));
    }
  }

  /**
   * @param gunPercent position of the dart gun's trigger now [%]
   */
  BoatJudge(
      BoatCourse course,
      RunningVehicle run,
      DoubleSupplier gunPercent,
      QuadrotorOnDeck quadrotor,
      Clock clock,
      Path directory) {
    this.run = run;
    this.gunPercent = gunPercent;
    this.quadrotor = quadrotor;
    this.clock = clock;
    tasks = new TaskJudge(course.sites(), quadrotor.gripper(), course.weather().seed(), this::say);
    home = course.home();
    this.directory = directory;
    speed = new Leg("speed gates", course.speedGates());
    out = new Leg("channel", course.channel());
    List<Gate> reversed = new ArrayList<>();
    course.channel().forEach(gate -> reversed.add(new Gate(gate.right(), gate.left())));
    Collections.reverse(reversed);
    back = new Leg("return channel", reversed);
  }

  @Override
  public void see(VehicleTruth truth) {
    Point now = Point.of(truth.position().y(), truth.position().x(), 0.0);
    if (before != null) {
      Leg leg = !speed.isDone() ? speed : !out.isDone() ? out : back;
      say(truth.timeS(), leg.move(before, now, truth.headingRad(), truth.timeS()));
    }
    if (!isHome && back.isDone() && now.flatDistanceTo(home) < HOME_M) {
      isHome = true;
      say(truth.timeS(), "home");
    }
    before = now;
    tasks.trigger(gunPercent.getAsDouble() > FIRES_PERCENT, truth);
    tasks.dock(truth, quadrotor.flown().map(flown -> flown.at(clock.micros())));
    over |= truth.timeS() >= RUN_S;
  }

  @Override
  public List<Channel<?>> listensTo() {
    return List.of(TargetReport.CHANNEL);
  }

  @Override
  public boolean heard(U2SAData data) {
    if (!(data instanceof TargetReport report)) {
      return false;
    }
    tasks.reported(report, run.at(clock.micros()).timeS());
    return true;
  }

  private void say(double timeS, String line) {
    if (line != null) {
      log.add(String.format(Locale.ROOT, "%6.1f s  %s", timeS, line));
    }
  }

  @Override
  public boolean isOver() {
    return over;
  }

  @Override
  public String phase(boolean moves) {
    return moves ? "SAILS" : "STANDS";
  }

  @Override
  public RunOutcome outcome() {
    run.contacts().forEach(each -> say(each.timeS(), tasks.words(each)));
    List<String> violations = new ArrayList<>();
    Map<String, Integer> counts = new LinkedHashMap<>();
    for (Leg leg : List.of(speed, out, back)) {
      if (!leg.isDone()) {
        violations.add(
            leg.name + ": " + leg.passed + " of " + leg.gates.size() + " gates passed in order");
      }
    }
    if (!isHome && !back.gates.isEmpty()) {
      violations.add("not home by the return channel in time");
    }
    counts.put("homeInTime", isHome ? 1 : 0);
    counts.put("speedGatesPassed", speed.passed);
    counts.put("channelGatesPassed", out.passed);
    counts.put("returnGatesPassed", back.passed);
    Map<String, Double> figures = new LinkedHashMap<>();
    if (speed.isDone() && !speed.gates.isEmpty()) {
      figures.put("speedGateSeconds", speed.lastS - speed.firstS);
    }
    tasks.outcome(run, violations, counts, figures);
    Collections.sort(log);
    ReportFile.writeText(
        directory.resolve("judge.log"), out -> out.write(String.join("\n", log) + "\n"));
    long contacts = run.contacts().stream().filter(each -> !tasks.isWanted(each)).count();
    return new RunOutcome((int) contacts, false, violations, counts, figures);
  }
}
