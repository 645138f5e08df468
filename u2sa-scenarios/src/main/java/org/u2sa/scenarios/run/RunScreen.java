package org.u2sa.scenarios.run;

import java.util.function.Consumer;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.report.TrackSample;
import org.u2sa.scenarios.terminal.LiveStatus;

/**
 * Shows a run on the terminal while it goes on. Belongs to the thread that calls {@link #accept}.
 */
final class RunScreen implements Consumer<TrackSample>, AutoCloseable {
  private final RunPlan plan;
  private final LiveStatus live;
  private final Clock stopwatch;
  private final long startMicros;

  /**
   * @param stopwatch real time, also where the run is faster
   */
  RunScreen(RunPlan plan, Terminal terminal, Clock stopwatch) {
    this.plan = plan;
    live = new LiveStatus(terminal);
    this.stopwatch = stopwatch;
    startMicros = stopwatch.micros();
  }

  @Override
  public void accept(TrackSample sample) {
    int count = plan.waypoints().size();
    boolean underWay = sample.leg() >= 0 && sample.leg() < count;
    live.update(
        new LiveStatus.Moment(
            sample,
            Math.min(sample.leg() + 1, count),
            count,
            underWay ? plan.waypoints().get(sample.leg()).name() : "",
            plan.distanceM(sample.leg(), sample.longitudeDeg(), sample.latitudeDeg()),
            Clock.seconds(stopwatch.micros() - startMicros)));
  }

  @Override
  public void close() {
    live.close();
  }
}
