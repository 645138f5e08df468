package org.u2sa.trials.run;

import java.util.function.Consumer;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Observes the ground truth of a run: an additional service. */
public interface RunObserver {
  /** Creates an observer. */
  @FunctionalInterface
  interface Maker {
    /**
     * Creates the observer; {@link DemoRun} starts and stops it.
     *
     * @param screen receives every sample, on the observer's thread
     */
    RunObserver make(ServiceContext context, RunPlan plan, Consumer<TrackSample> screen);
  }

  /** The observer as a service. */
  U2SAService service();

  /** The recorded data. */
  RunRecord record();

  /** Whether the vehicle's run is over. Thread-safe. */
  boolean isOver();

  /** The outcome; call only after the service has stopped. */
  RunOutcome outcome();
}
