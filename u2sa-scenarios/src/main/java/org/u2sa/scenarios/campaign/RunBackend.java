package org.u2sa.scenarios.campaign;

import java.util.List;
import java.util.function.BiConsumer;

/**
 * Makes the runs of a campaign: on processes of this machine, on a cluster. Each run has a process
 * to itself while it lasts, with this program's classes; one whose process dies is made again, and
 * given up when that dies, too. Where a run is made does not change what comes of it.
 */
public interface RunBackend {
  /** On what the runs are made, such as "2 processes". */
  String inWords();

  /**
   * Makes all runs, and returns when they are done or it was stopped. Afterwards the files of those
   * that failed, and of those that keep them, are in the campaign's folder; of others there are
   * none.
   *
   * @param done is told of each run as it ends, in any order, by one thread at a time; if it
   *     throws, no more runs are begun, and what it threw is thrown here
   * @throws org.u2sa.gcs.command.RunFailedException if runs cannot be made at all
   */
  void run(List<RunRequest> requests, BiConsumer<RunRequest, RunAnswer> done)
      throws InterruptedException;

  /** Begins no more runs and breaks off those under way. For any thread, at any time. */
  void stop();
}
