package org.u2sa.service;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.EmergencyStop;

/**
 * Whether an emergency stop holds. Each stop latches for itself; only a clear lifts it that names
 * it, or that names none and its timestamp or a later one. Whoever could be wrong is wrong on the
 * safe side: a stop of unknown origin or time latches too, a clear of another system lifts nothing.
 *
 * <p>Not safe for several threads: it belongs to one service.
 */
public final class EmergencyLatch {
  /** Stops that are told apart; of more, as a flood makes them, only the newest is known. */
  private static final int TOLD_APART = 64;

  private static final String STANDING = "EMERGENCY STOPS";
  private static final String LIFTED = "LIFTED EMERGENCY STOPS";

  private final Clock clock;
  private final String systemId;
  private final Map<String, EmergencyStop> standing = new LinkedHashMap<>(); // by identity
  private final Set<String> lifted = new LinkedHashSet<>(); // identities, the oldest first
  private EmergencyStop beyond; // the newest of those that are not told apart; null if none stands

  /**
   * @param clock stands in for timestamps that stops lack
   * @param systemId whose clears count
   */
  public EmergencyLatch(Clock clock, String systemId) {
    this.clock = clock;
    this.systemId = systemId;
  }

  /**
   * Takes note of a stop or a clear. A repetition of a stop that was lifted, as one says it who has
   * not heard of the clear yet, changes nothing.
   *
   * @return whether the first stop came to hold or the last one ceased to
   */
  public boolean accept(EmergencyStop message) {
    boolean before = isStopped();
    if (message.active()) {
      latch(message);
    } else if (message.systemId().isEmpty() || message.systemId().equals(systemId)) {
      lift(message);
    }
    return isStopped() != before;
  }

  private void latch(EmergencyStop message) {
    EmergencyStop stop = message.timestamp().isPresent() ? message : stamped(message);
    if (lifted.contains(stop.identity()) || standing.containsKey(stop.identity())) {
      return;
    }
    if (standing.size() < TOLD_APART) {
      standing.put(stop.identity(), stop);
    } else if (beyond == null || micros(stop) > micros(beyond)) {
      beyond = stop;
    }
  }

  /** So that a repetition, and the clear that names it, mean this one. */
  private EmergencyStop stamped(EmergencyStop message) {
    EmergencyStop copy = (EmergencyStop) message.copy();
    copy.timestamp(clock.micros());
    return copy;
  }

  private static long micros(EmergencyStop stop) {
    return stop.timestamp().orElse(Long.MIN_VALUE);
  }

  private void lift(EmergencyStop clear) {
    Set<String> names = Set.copyOf(clear.lifts());
    long untilMicros = clear.clears().orElse(Long.MIN_VALUE);
    Iterator<EmergencyStop> stops = standing.values().iterator();
    while (stops.hasNext()) {
      EmergencyStop stop = stops.next();
      if (names.isEmpty() ? micros(stop) <= untilMicros : names.contains(stop.identity())) {
        stops.remove();
        remember(stop.identity());
      }
    }
    if (beyond != null && micros(beyond) <= untilMicros) {
      beyond = null;
    }
  }

  private void remember(String identity) {
    lifted.add(identity);
    if (lifted.size() > 2 * TOLD_APART) {
      Iterator<String> oldest = lifted.iterator();
      oldest.next();
      oldest.remove();
    }
  }

  /** Whether a stop holds. */
  public boolean isStopped() {
    return !standing.isEmpty() || beyond != null;
  }

  /** The newest stop that holds; empty if none does. */
  public Optional<EmergencyStop> stop() {
    return stops().stream().reduce((one, other) -> micros(other) >= micros(one) ? other : one);
  }

  /** All stops that hold and are told apart, in the order in which they came. */
  public List<EmergencyStop> stops() {
    List<EmergencyStop> stops = new ArrayList<>(standing.values());
    if (beyond != null) {
      stops.add(beyond);
    }
    return stops;
  }

  /** Which stops hold, by {@link EmergencyStop#identity()}. */
  public List<String> identities() {
    List<String> identities = new ArrayList<>();
    stops().forEach(stop -> identities.add(stop.identity()));
    return Collections.unmodifiableList(identities);
  }

  /** Writes down what holds and what was lifted, for whoever takes the service's place. */
  public void handOver(HandOver state) {
    state.messages(STANDING, stops()).texts(LIFTED, lifted);
  }

  /** Goes on from what {@link #handOver} wrote; with nothing of that it begins without a stop. */
  public void takeOver(HandOver state) {
    lifted.addAll(state.texts(LIFTED));
    state.messages(STANDING, EmergencyStop.class).forEach(this::latch);
  }
}
