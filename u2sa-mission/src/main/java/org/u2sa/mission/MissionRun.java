package org.u2sa.mission;

import java.util.function.DoubleSupplier;
import org.u2sa.interfaces.time.Clock;

/** The mission that is carried out, and how far. Confined to the manager's thread. */
final class MissionRun {
  private final Clock clock;
  private final DoubleSupplier thresholdM;
  private Mission mission; // as in its file
  private MissionProgress progress;

  /**
   * @param thresholdM default horizontal threshold of waypoints [m]
   */
  MissionRun(Clock clock, DoubleSupplier thresholdM) {
    this.clock = clock;
    this.thresholdM = thresholdM;
  }

  /** The mission as in its file. */
  Mission mission() {
    return mission;
  }

  void mission(Mission loaded) {
    mission = loaded;
  }

  MissionProgress progress() {
    return progress;
  }

  void progress(MissionProgress reached) {
    progress = reached;
  }

  /** Default horizontal threshold of waypoints [m]. */
  double thresholdM() {
    return thresholdM.getAsDouble();
  }

  /** Current time [µs of the run's clock]. */
  long micros() {
    return clock.micros();
  }
}
