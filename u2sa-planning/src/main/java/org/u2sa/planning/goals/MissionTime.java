package org.u2sa.planning.goals;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.service.handover.HandOver;

/** Time since the start of the mission, the time base of goals. */
public final class MissionTime {
  private long startMicros = Long.MIN_VALUE; // mission start, if time had always counted

  /** Mission start: the list's elapsed time ago, or else the arrival of its first goals [µs]. */
  public void update(GoalList list, long nowMicros) {
    if (list.elapsed().isPresent()) {
      startMicros =
          Math.min(nowMicros, list.timestamp().orElse(nowMicros))
              - Clock.micros(list.elapsed().getAsDouble());
    } else if (list.goals().isEmpty()) {
      startMicros = Long.MIN_VALUE;
    } else if (startMicros == Long.MIN_VALUE) {
      startMicros = nowMicros;
    }
  }

  /** Time for which the mission has been pursued [s]; 0 before its start. */
  public double elapsedS(long nowMicros) {
    return startMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(nowMicros - startMicros);
  }

  public void handOver(HandOver state) {
    if (startMicros != Long.MIN_VALUE) {
      state.number("MISSION SINCE", Clock.seconds(startMicros));
    }
  }

  public void takeOver(HandOver state) {
    state.number("MISSION SINCE").ifPresent(seconds -> startMicros = Clock.micros(seconds));
  }
}
