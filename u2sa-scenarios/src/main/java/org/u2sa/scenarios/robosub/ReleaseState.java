package org.u2sa.scenarios.robosub;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.Plan;

/** Releases a payload twice, each time when the vehicle is aimed (thesis 4.3.1.5). */
abstract class ReleaseState extends SightState {
  private static final int SHOTS = 2; // maximum number of payloads
  private static final double COMMANDED_S = 1.0; // longer than the release's hold time
  private static final double PAUSE_S = 1.5; // for the mechanism to lock again

  private final String actuator;
  private int shots;
  private long shotMicros;

  /**
   * @param actuator name of the release and of its subsystem
   */
  ReleaseState(TaskSight sight, String actuator) {
    super(sight);
    this.actuator = actuator;
  }

  @Override
  void begin() {
    shots = 0;
    shotMicros = Long.MIN_VALUE / 2;
  }

  /** Releases again if aimed; otherwise follows a plan. */
  final Plan release(boolean isAimed, Plan holding, StateInformation state) {
    double sinceS = Clock.seconds(state.timestamp().orElseThrow() - shotMicros);
    if (sinceS < COMMANDED_S) {
      List<NavigationPoint> points = new ArrayList<>(holding.points());
      points.add(NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).subsystem(actuator));
      return Plan.underWay(points);
    }
    if (sinceS > COMMANDED_S + PAUSE_S) {
      if (shots == SHOTS) {
        return completed("released " + SHOTS);
      }
      if (isAimed) {
        shots++;
        shotMicros = state.timestamp().orElseThrow();
      }
    }
    return holding;
  }
}
