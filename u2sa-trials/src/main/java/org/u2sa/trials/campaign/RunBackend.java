package org.u2sa.trials.campaign;

import java.util.List;
import java.util.function.BiConsumer;

/**
 * Executes the runs of a campaign, on processes of this machine or on a cluster. Each run has
 * exclusive use of a process with this program's classes. If the process dies, the run is retried
 * once and then abandoned. Results do not depend on where a run is executed.
 */
public interface RunBackend {
  /** Description of the backend, such as "2 processes". */
  String inWords();

  /**
   * Executes all runs, and returns when they are done or it was stopped. Files of failed runs, and
   * of runs that keep them, are then in the campaign's folder; those of other runs are deleted.
   *
   * @param done called for each finished run, in any order, by one thread at a time; if it throws,
   *     no more runs are started and the exception is rethrown here
   * @throws org.u2sa.interfaces.RunFailedException if no run can be executed
   */
  void run(List<RunRequest> requests, BiConsumer<RunRequest, RunAnswer> done)
      throws InterruptedException;

  /** Starts no more runs and aborts the current ones. Thread-safe; may be called at any time. */
  void stop();
}
