package org.u2sa.scenarios.suas;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.scenarios.suas.score.BoundaryCount;
import org.u2sa.scenarios.suas.score.ObjectScore;
import org.u2sa.scenarios.suas.score.ReportedTrack;
import org.u2sa.scenarios.suas.score.ScoreSheet;
import org.u2sa.scenarios.suas.score.WaypointScore;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.ScriptedMover;
import org.u2sa.trials.run.TruthObserver;
import org.u2sa.vision.survey.SurveyTarget;

/**
 * Scores a flight: waypoints by the aircraft's telemetry, everything else by ground truth. Each
 * breach of the rules is a violation.
 */
final class SuasJudge implements TruthObserver.Scorer {
  /** Time limit of a flight [s]. */
  static final double RUN_S = 30.0 * 60.0;

  private static final double REPORTS_S = 0.5; // telemetry interval
  private static final double MAP_SHARE = 0.99;
  private static final double RUNWAY_SIDE_M = 12.0;
  private static final double NEAR_M =
      15.0; // maximum error of a reported position (the sixth field)
  private static final int RIGHT_FIELDS = 3; // minimum number of the other five fields
  private static final double PASS_M = 15.24; // 50 ft
  private static final double LONGEST_GAP_S = 1.0; // maximum gap in the telemetry

  private final SuasField field;
  private final SeenCells cells;
  private final Path directory;
  private final List<ScriptedMover> movers;
  private final ReportedTrack telemetry = new ReportedTrack();
  private final BoundaryCount boundary = new BoundaryCount();
  private final List<Double> outS = new ArrayList<>();
  private final Set<String> hit = new LinkedHashSet<>();
  private final double[] nearestM; // true distance from each waypoint
  private final List<String> log = new ArrayList<>();
  private final Map<String, ObjectScore.Sheet> reports = new LinkedHashMap<>(); // by target
  private final Aboard aboard;
  private boolean isReleased;
  private double dropM = Double.POSITIVE_INFINITY; // distance from its target
  private double longestGapS;
  private int corrections;
  private int takeovers;
  private boolean isByHand;
  private FailsafeAction failsafe = FailsafeAction.CONTINUE;
  private double nowS;
  private VehicleTruth last;
  private double reportedS = Double.NEGATIVE_INFINITY;
  private volatile boolean over;

  /**
   * Inputs besides the ground truth.
   *
   * @param released whether the bottle has been dropped
   * @param hears whether telemetry arrives at the ground station
   * @param changes number of mission changes made in flight
   * @param figures metrics of a mosaic, if one is made
   */
  record Aboard(
      BooleanSupplier released,
      BooleanSupplier hears,
      IntSupplier changes,
      Supplier<Map<String, Double>> figures) {}

  SuasJudge(SuasField field, SeenCells cells, Aboard aboard, Path directory) {
    this.field = field;
    this.aboard = aboard;
    this.cells = cells;
    this.directory = directory;
    movers = field.movers();
    nearestM = new double[field.waypoints().size()];
    Arrays.fill(nearestM, Double.POSITIVE_INFINITY);
  }

  @Override
  public List<Channel<?>> listensTo() {
    return List.of(Channels.STATE, Channels.MANUAL_STATE, Channels.FAILSAFE, SurveyTarget.CHANNEL);
  }

  @Override
  public boolean heard(U2SAData data) {
    if (data instanceof SurveyTarget report) {
      Point at = SuasField.plane().point(new Geodetic(report.x(), report.y(), report.z()));
      ObjectScore.Sheet sheet = new ObjectScore.Sheet(at.x(), at.y(), report.fields());
      boolean isNew = reports.put(report.uid(), sheet) == null;
      corrections += isNew ? 0 : 1;
      say((isNew ? "report: " : "correction: ") + String.join(", ", report.fields()));
      return true;
    }
    if (data instanceof FailsafeState state) {
      if (state.action() != failsafe) {
        say("failsafe " + state.action() + ": " + String.join(", ", state.causes()));
      }
      failsafe = state.action();
      return true;
    }
    if (data instanceof ManualState state) {
      boolean isNew = state.active() && state.takeovers() > takeovers;
      takeovers = (int) state.takeovers();
      if (isNew || state.active() != isByHand) {
        say(isNew ? "takeover " + takeovers : state.active() ? "by hand" : "automatic");
      }
      isByHand = state.active();
      return true;
    }
    if (!(data instanceof StateInformation state)) {
      return false;
    }
    boolean isPlaced =
        state.referenceFrame().equals(ReferenceFrame.GLOBAL)
            && state.x().isPresent()
            && state.y().isPresent()
            && state.z().isPresent();
    if (isPlaced && aboard.hears().getAsBoolean() && nowS - reportedS >= REPORTS_S) {
      longestGapS = reportedS > 0.0 ? Math.max(longestGapS, nowS - reportedS) : longestGapS;
      reportedS = nowS;
      Point at =
          SuasField.plane()
              .point(
                  new Geodetic(
                      state.x().getAsDouble(), state.y().getAsDouble(), state.z().getAsDouble()));
      telemetry.add(new ReportedTrack.Sample(nowS, at.x(), at.y(), at.z()));
    }
    return true;
  }

  @Override
  public void see(VehicleTruth truth) {
    nowS = truth.timeS();
    last = truth;
    Point at = truth.position();
    boolean isInside = SuasField.isInside(field.boundary(), at.x(), at.y());
    if (!isInside || at.z() > field.ceilingM()) {
      outS.add(nowS);
    }
    if (boundary.see(nowS, isInside && at.z() <= field.ceilingM())) {
      say(String.format(Locale.ROOT, "out of bounds, %.1f m high", at.z()));
    }
    for (int i = 0; i < field.pillars().size(); i++) {
      SuasField.Pillar pillar = field.pillars().get(i);
      boolean inside =
          at.z() < pillar.heightM()
              && Math.hypot(at.x() - pillar.eastM(), at.y() - pillar.northM()) < pillar.radiusM();
      enter(inside, "pillar " + (i + 1));
    }
    for (ScriptedMover mover : movers) {
      double away = mover.at(nowS).position().distanceTo(at);
      enter(away < SuasField.SEPARATION_M, mover.uid());
    }
    if (!isReleased && aboard.released().getAsBoolean()) {
      isReleased = true;
      Point landing = DroppedBottle.landing(field, truth);
      dropM = Math.hypot(landing.x() - field.drop().x(), landing.y() - field.drop().y());
      say(String.format(Locale.ROOT, "bottle released, lands %.1f m from its target", dropM));
    }
    for (int i = 0; i < nearestM.length; i++) {
      nearestM[i] = Math.min(nearestM[i], field.waypoints().get(i).distanceTo(at));
    }
    over |= nowS >= RUN_S;
  }

  /** Whether the aircraft is standing on the runway. */
  private boolean hasLanded() {
    if (last == null || last.speedMps() > 0.5 || last.position().z() > 2.0) {
      return false;
    }
    Point at = last.position();
    double along = at.x() * Math.sin(field.runwayRad()) + at.y() * Math.cos(field.runwayRad());
    double across = at.x() * Math.cos(field.runwayRad()) - at.y() * Math.sin(field.runwayRad());
    return Math.abs(along) < SuasField.RUNWAY_HALF_M && Math.abs(across) < RUNWAY_SIDE_M;
  }

  private List<ObjectScore.Sheet> targets() {
    List<ObjectScore.Sheet> targets = new ArrayList<>();
    for (SuasTarget each : field.targets()) {
      say("target: " + each);
      targets.add(
          new ObjectScore.Sheet(
              each.eastM(),
              each.northM(),
              List.of(
                  each.shape(),
                  each.colour(),
                  each.letter(),
                  each.letterColour(),
                  each.orientation())));
    }
    return targets;
  }

  /** For each obstacle, 1 if it was hit. */
  private List<Integer> hits() {
    List<Integer> hits = new ArrayList<>();
    for (int i = 0; i < field.pillars().size(); i++) {
      hits.add(hit.contains("pillar " + (i + 1)) ? 1 : 0);
    }
    movers.forEach(mover -> hits.add(hit.contains(mover.uid()) ? 1 : 0));
    return hits;
  }

  private void enter(boolean isInside, String name) {
    if (isInside && hit.add(name)) {
      say("enters " + name);
    }
  }

  private void say(String line) {
    log.add(String.format(Locale.ROOT, "%6.1f s  %s", nowS, line));
  }

  @Override
  public boolean isOver() {
    return over;
  }

  /** Without a ground station, the flight continues until it is terminated. */
  @Override
  public boolean isWaiting() {
    return !aboard.hears().getAsBoolean();
  }

  @Override
  public String phase(boolean moves) {
    return moves ? "FLIES" : "STANDS";
  }

  @Override
  public RunOutcome outcome() {
    List<Double> scores = WaypointScore.scores(field.waypoints(), telemetry.interpolated());
    boolean landed = hasLanded();
    int obstacles = field.pillars().size() + movers.size();
    List<ObjectScore.Sheet> targets = targets();
    ObjectScore.Result objects = ObjectScore.of(targets, List.copyOf(reports.values()));
    ScoreInput.write(
        field,
        telemetry.reports(),
        List.copyOf(reports.values()),
        targets,
        outS,
        hits(),
        directory.resolve("score-input.csv"));
    ScoreSheet sheet =
        new ScoreSheet(
            nowS < RUN_S ? 1.0 : 0.0,
            scores.stream().mapToDouble(Double::doubleValue).average().orElse(0.0),
            telemetry.meanGapS(),
            takeovers,
            boundary.count(),
            !landed && last != null && last.position().z() < 2.0,
            obstacles - hit.size(),
            obstacles,
            objects.score(),
            cells.share() >= MAP_SHARE ? 1.0 : cells.share(),
            ScoreSheet.drop(dropM),
            1.0);
    List<String> violations = new ArrayList<>();
    if (boundary.count() > 0) {
      violations.add("out of bounds " + boundary.count() + " times");
    }
    hit.forEach(each -> violations.add("entered " + each));
    if (cells.share() < MAP_SHARE) {
      violations.add(
          String.format(Locale.ROOT, "%.1f %% of the search area seen", 100.0 * cells.share()));
    }
    long good =
        objects.matches().stream()
            .filter(each -> each.distanceM() <= NEAR_M && each.rightFields() >= RIGHT_FIELDS)
            .count();
    if (good < field.targets().size()) {
      violations.add(good + " of " + field.targets().size() + " targets with four of six fields");
    }
    if (longestGapS > LONGEST_GAP_S) {
      violations.add(String.format(Locale.ROOT, "no telemetry for %.1f s", longestGapS));
    }
    if (!isReleased) {
      violations.add("the bottle was not dropped");
    }
    if (failsafe == FailsafeAction.STOP) {
      violations.add("the flight was terminated");
    }
    if (!landed) {
      violations.add("does not stand on the runway at the end");
    }
    int passed = 0;
    for (double each : nearestM) {
      passed += each <= PASS_M ? 1 : 0;
    }
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put("waypointsPassed", passed);
    counts.put("targets", field.targets().size());
    counts.put("targetsFound", objects.matches().size());
    counts.put("targetsRight", (int) good);
    counts.put("falseReports", objects.falseReports());
    counts.put("landedOnRunway", landed ? 1 : 0);
    counts.put("obstaclesHit", hit.size());
    counts.put("boundaryLeft", boundary.count());
    counts.put("missionChanges", aboard.changes().getAsInt());
    counts.put("corrections", corrections);
    counts.put("takeovers", takeovers);
    Map<String, Double> figures = new LinkedHashMap<>(sheet.figures());
    figures.put("areaSeen", cells.share());
    if (cells.highestM() > 0.0) {
      figures.put("surveyHeightLeastM", cells.lowestM());
      figures.put("surveyHeightGreatestM", cells.highestM());
    }
    figures.put("longestTelemetryGapS", longestGapS);
    if (isReleased) {
      figures.put("dropErrorM", dropM);
    }
    figures.putAll(aboard.figures().get());
    ReportFile.writeText(
        directory.resolve("judge.log"), out -> out.write(String.join("\n", log) + "\n"));
    return new RunOutcome(0, false, violations, counts, figures);
  }
}
