package org.u2sa.scenarios.run;

import java.util.function.Consumer;
import org.u2sa.scenarios.report.RunOutcome;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.report.TrackSample;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** What watches the truth of a run: a service beside those of the system. */
public interface RunObserver {
  /** Makes one. */
  @FunctionalInterface
  interface Maker {
    /**
     * Makes it, for {@link DemoRun} to start and end.
     *
     * @param screen is to be shown every sample, on the observer's thread
     */
    RunObserver make(ServiceContext context, RunPlan plan, Consumer<TrackSample> screen);
  }

  /** The service itself. */
  U2SAService service();

  /** What it has recorded. */
  RunRecord record();

  /** Whether the run is over, as far as the vehicle is concerned. Safe from any thread. */
  boolean isOver();

  /** How it ended; for when the service has ended. */
  RunOutcome outcome();
}
