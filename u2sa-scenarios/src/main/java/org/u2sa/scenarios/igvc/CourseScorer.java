package org.u2sa.scenarios.igvc;

import java.nio.file.Path;
import java.util.List;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.trials.run.TruthObserver;

/** Feeds a run to the judge and the film, and writes their results at the end. */
final class CourseScorer implements TruthObserver.Scorer {
  private final Judge judge;
  private final RunFilm film;
  private final RunSnapshots snapshots;
  private final Path directory;

  CourseScorer(Judge judge, RunFilm film, RunSnapshots snapshots, Path directory) {
    this.snapshots = snapshots;
    this.judge = judge;
    this.film = film;
    this.directory = directory;
  }

  @Override
  public void see(VehicleTruth truth) {
    judge.see(truth);
    film.see(truth);
    if (snapshots.isDue(truth.timeS())) {
      film.newest().ifPresent(moment -> snapshots.write(truth.timeS(), moment, film));
    }
  }

  @Override
  public List<Channel<?>> listensTo() {
    return List.of(Channels.PLANS, Channels.OBJECTS, Channels.GRID, Channels.STATE);
  }

  @Override
  public boolean heard(U2SAData data) {
    if (data instanceof PlannedPath plan) {
      film.plan(plan);
    } else if (data instanceof ObjectList objects) {
      film.objects(objects);
    } else if (data instanceof OccupancyGrid grid) {
      snapshots.grid(grid);
    } else if (data instanceof StateInformation state) {
      snapshots.state(state);
    } else {
      return false;
    }
    return true;
  }

  @Override
  public String phase(boolean moves) {
    return moves ? "DRIVES" : "STANDS";
  }

  @Override
  public boolean isOver() {
    return judge.isOver();
  }

  @Override
  public RunOutcome outcome() {
    ReportFile.writeText(
        directory.resolve("judge.log"), out -> out.write(String.join("\n", judge.log()) + "\n"));
    film.write();
    return judge.outcome();
  }
}
