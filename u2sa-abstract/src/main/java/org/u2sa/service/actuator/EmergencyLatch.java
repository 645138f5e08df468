package org.u2sa.service.actuator;

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
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.handover.HandOver;

/**
 * Latch for emergency stops. Each stop latches separately; it is lifted only by a clear that names
 * it, or that names no stop and has the same or a later timestamp. Fail-safe: a stop of unknown
 * origin or time latches too, and a clear from another system lifts nothing.
 *
 * <p>Not thread-safe: belongs to one service.
 */
public final class EmergencyLatch {
  /**
   * Maximum number of stops tracked individually; beyond it, as in a flood, only the newest is
   * kept.
   */
  private static final int TOLD_APART = 64;

  private static final String STANDING = "EMERGENCY STOPS";
  private static final String LIFTED = "LIFTED EMERGENCY STOPS";

  private final Clock clock;
  private final String systemId;
  private final Map<String, EmergencyStop> standing = new LinkedHashMap<>(); // by identity
  private final Set<String> lifted = new LinkedHashSet<>(); // identities, the oldest first
  private EmergencyStop beyond; // newest untracked stop; null if none is active

  /**
   * @param clock replaces missing timestamps of stops
   * @param systemId system whose clears are accepted
   */
  public EmergencyLatch(Clock clock, String systemId) {
    this.clock = clock;
    this.systemId = systemId;
  }

  /**
   * Processes a stop or a clear. A repeat of a lifted stop, from a sender that has not received the
   * clear yet, changes nothing.
   *
   * @return whether the latch changed state: first stop set or last stop cleared
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

  /** Lets a repeat, and the clear that names it, match this stop. */
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

  /** Whether a stop is active. */
  public boolean isStopped() {
    return !standing.isEmpty() || beyond != null;
  }

  /** The newest active stop; empty if none. */
  public Optional<EmergencyStop> stop() {
    return stops().stream().reduce((one, other) -> micros(other) >= micros(one) ? other : one);
  }

  /** All active tracked stops, in order of arrival. */
  public List<EmergencyStop> stops() {
    List<EmergencyStop> stops = new ArrayList<>(standing.values());
    if (beyond != null) {
      stops.add(beyond);
    }
    return stops;
  }

  /** Active stops, by {@link EmergencyStop#identity()}. */
  public List<String> identities() {
    List<String> identities = new ArrayList<>();
    stops().forEach(stop -> identities.add(stop.identity()));
    return Collections.unmodifiableList(identities);
  }

  /** Saves the active and the lifted stops for the service's successor. */
  public void handOver(HandOver state) {
    state.messages(STANDING, stops()).texts(LIFTED, lifted);
  }

  /** Restores the state saved by {@link #handOver}; without it, starts with no stop. */
  public void takeOver(HandOver state) {
    lifted.addAll(state.texts(LIFTED));
    state.messages(STANDING, EmergencyStop.class).forEach(this::latch);
  }
}
