package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.trials.run.TruthObserver;

/**
 * Times a task and scores it by ground truth. The ready state begins when the vehicle is armed:
 * VRX's initial state, in which it is moored, is omitted.
 */
abstract class VrxJudge implements TruthObserver.Scorer {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final VrxWorld world;
  private final Path directory;
  private final List<String> log = new ArrayList<>();
  private double runsFromS = NEVER;
  private double lastS; // of the running state
  private volatile boolean over;

  /**
   * @param directory for judge.log
   */
  VrxJudge(VrxWorld world, Path directory) {
    this.world = world;
    this.directory = directory;
  }

  /**
   * The judge of a world's task.
   *
   * @param outline outline of the vehicle
   */
  static VrxJudge of(VrxWorld world, Footprint outline, Path directory) {
    return switch (world.task()) {
      case STATIONKEEPING -> new StationJudge(world, directory);
      case WAYFINDING -> new WayfindingJudge(world, directory);
      case PATH -> new PathJudge(world, outline, directory);
      case WILDLIFE -> new WildlifeJudge(world, outline, directory);
      case DOCK -> new DockJudge(world, outline, directory);
    };
  }

  final VrxWorld world() {
    return world;
  }

  @Override
  public final void armed(ArmingState state, VehicleTruth truth) {
    if (state.armed() && runsFromS == NEVER) {
      runsFromS = truth.timeS() + world.times().readyS();
    }
  }

  @Override
  public final void see(VehicleTruth truth) {
    double sinceS = truth.timeS() - runsFromS;
    if (over || !(sinceS >= 0.0)) {
      return;
    }
    if (sinceS > world.times().runningS()) {
      finish();
      return;
    }
    lastS = sinceS;
    score(truth, sinceS);
  }

  /** Scores the vehicle's pose at a time of the running state [s]. */
  abstract void score(VehicleTruth truth, double sinceS);

  /** The task's score so far. */
  abstract double score();

  /** Further metrics for the summary. */
  abstract Map<String, Double> figures();

  /** Number of collisions. */
  int contacts() {
    return 0;
  }

  /** Ends the task. */
  final void finish() {
    over = true;
  }

  final void say(double sinceS, String what) {
    log.add(String.format(Locale.ROOT, "%7.2f s  %s", sinceS, what));
  }

  @Override
  public final boolean isOver() {
    return over;
  }

  @Override
  public final RunOutcome outcome() {
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("score", score());
    figures.put("scoredSeconds", lastS);
    figures.putAll(figures());
    say(lastS, String.format(Locale.ROOT, "score %.4f", score()));
    ReportFile.writeText(
        directory.resolve("judge.log"), out -> out.write(String.join("\n", log) + "\n"));
    List<String> violations =
        runsFromS == NEVER ? List.of("the vehicle was never armed") : List.of();
    return new RunOutcome(contacts(), false, violations, Map.of(), figures);
  }
}
