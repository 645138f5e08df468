package org.u2sa.scenarios.encounters;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.trials.run.TruthObserver;

/** Feeds a run to its score, and writes the score to {@code encounters.txt}. */
final class EncounterScorer implements TruthObserver.Scorer {
  static final String FILE = "encounters.txt";

  private final EncounterScore score;
  private final Path directory;
  private Point last; // east, north, up [m]
  private double lastS;
  private boolean isThere;

  EncounterScorer(EncounterScore score, Path directory) {
    this.score = score;
    this.directory = directory;
  }

  @Override
  public void reported(GoalInformation report) {
    isThere = true;
  }

  @Override
  public void see(VehicleTruth truth) {
    if (isThere) {
      return; // it stops at the end of the mission
    }
    Point at = truth.position();
    if (last != null) {
      double since = truth.timeS() - lastS;
      double north = (at.y() - last.y()) / since;
      double east = (at.x() - last.x()) / since;
      double course = Math.atan2(east, north);
      double time = truth.timeS() - EncounterDemo.START_S;
      score.see(time, at.y(), at.x(), course, Math.hypot(north, east));
    }
    last = at;
    lastS = truth.timeS();
  }

  @Override
  public List<Channel<?>> listensTo() {
    return List.of(Channels.HEALTH);
  }

  @Override
  public boolean heard(U2SAData data) {
    if (data instanceof HealthReport report) {
      report.remarks().forEach(score::hear);
      return true;
    }
    return false;
  }

  @Override
  public RunOutcome outcome() {
    List<String> lines = new ArrayList<>(score.lines());
    score.violations().forEach(each -> lines.add("  ! " + each));
    ReportFile.writeText(
        directory.resolve(FILE), out -> out.write(String.join("\n", lines) + "\n"));
    return new RunOutcome(
        0,
        false,
        score.violations(),
        Map.of(),
        Map.of("rangeM", score.nearestM(), "encounterScore", score.score()));
  }
}
