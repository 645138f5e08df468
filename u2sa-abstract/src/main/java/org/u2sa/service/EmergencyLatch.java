package org.u2sa.service;

import java.util.Optional;
import org.u2sa.interfaces.Clock;
import org.u2sa.messages.contract.EmergencyStop;

/**
 * Whether an emergency stop holds. A stop latches; only a clear that names its timestamp or a later
 * one lifts it. Whoever could be wrong is wrong on the safe side: a stop of unknown origin or time
 * latches too, a clear of another system lifts nothing.
 *
 * <p>Not safe for several threads: it belongs to one service.
 */
public final class EmergencyLatch {
  private final Clock clock;
  private final String systemId;
  private EmergencyStop stop; // the newest that holds; null if none does
  private long stoppedMicros;
  private long liftedMicros = Long.MIN_VALUE; // timestamp of the stop that was lifted last

  /**
   * @param clock stands in for timestamps that stops lack
   * @param systemId whose clears count
   */
  public EmergencyLatch(Clock clock, String systemId) {
    this.clock = clock;
    this.systemId = systemId;
  }

  /**
   * Takes note of a stop or a clear. A repetition of the stop that was lifted last, as one says it
   * who has not heard of the clear yet, changes nothing.
   *
   * @return whether a stop came to hold or ceased to
   */
  public boolean accept(EmergencyStop message) {
    return message.active() ? latch(message) : lift(message);
  }

  private boolean latch(EmergencyStop message) {
    long at = message.timestamp().orElse(clock.micros());
    boolean first = stop == null;
    if (first && at == liftedMicros) {
      return false;
    }
    if (first || at > stoppedMicros) {
      stop = message.timestamp().isPresent() ? message : stamped(message, at);
      stoppedMicros = at;
    }
    return first;
  }

  /** So that a repetition, and the clear that names it, mean this one. */
  private static EmergencyStop stamped(EmergencyStop message, long atMicros) {
    EmergencyStop copy = (EmergencyStop) message.copy();
    copy.timestamp(atMicros);
    return copy;
  }

  private boolean lift(EmergencyStop message) {
    boolean foreign = !message.systemId().isEmpty() && !message.systemId().equals(systemId);
    if (stop == null || foreign || message.clears().orElse(Long.MIN_VALUE) < stoppedMicros) {
      return false;
    }
    liftedMicros = stoppedMicros;
    stop = null;
    return true;
  }

  /** Whether a stop holds. */
  public boolean isStopped() {
    return stop != null;
  }

  /** The newest stop that holds; empty if none does. */
  public Optional<EmergencyStop> stop() {
    return Optional.ofNullable(stop);
  }
}
