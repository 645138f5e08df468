package org.u2sa.control;

import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;

/** Keeps recent states by timestamp. */
final class StateHistory {
  private long spanMicros;
  private final TreeMap<Long, StateInformation> states = new TreeMap<>();
  private long lastStepMicros;

  /** Sets the history span, and the maximum age of a fresh message [µs]. */
  void span(long newSpanMicros) {
    spanMicros = newSpanMicros;
  }

  /**
   * Adds a state that has a timestamp.
   *
   * @return false if it is not newer than the newest state; a state that is older by more than the
   *     span restarts the history, because the clock was set back
   */
  boolean add(StateInformation state) {
    long time = state.timestamp().orElseThrow();
    long step = states.isEmpty() ? 0L : time - states.lastKey();
    if (step <= 0 && !states.isEmpty() && step >= -spanMicros) {
      return false;
    }
    if (Math.abs(step) > spanMicros) {
      states.clear();
      step = 0L;
    }
    lastStepMicros = step;
    states.put(time, state);
    while (states.firstKey() < time - spanMicros) {
      states.pollFirstEntry();
    }
    return true;
  }

  /** Time between the two newest states [µs]; 0 if the newest starts a history. */
  long lastStepMicros() {
    return lastStepMicros;
  }

  /** All remembered states, oldest first. */
  Collection<StateInformation> all() {
    return states.values();
  }

  /** State with exactly this timestamp. */
  Optional<StateInformation> at(long micros) {
    return Optional.ofNullable(states.get(micros));
  }

  /** Whether a message is not older than the newest state by more than the span. */
  boolean isFresh(U2SAData message) {
    Map.Entry<Long, StateInformation> newest = states.lastEntry();
    return newest != null
        && message.timestamp().isPresent()
        && Math.abs(newest.getKey() - message.timestamp().getAsLong()) <= spanMicros;
  }
}
