package org.u2sa.service.actuator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ObeyedOrders;

/**
 * Latch for emergency stops. Each stop latches separately, and is cleared only by a clear with its
 * ID, or one without ID and with the same or a later timestamp. Fail-safe: a stop of unknown origin
 * or time latches too, a stop that reuses the ID of a cleared one latches again, and a clear from
 * another system, or one that arrives again, has no effect: since the first time another stop may
 * have been given, by a clock that is behind. Not thread-safe.
 */
public final class EmergencyLatch {
  /** Stops tracked individually; beyond it, as in a flood, only the newest is kept. */
  private static final int TOLD_APART = 64;

  /**
   * Time after the clear during which a stop without a timestamp may be a repeat of the cleared one
   * [µs]: several repeat intervals.
   */
  private static final long REPEATED_MICROS = 10 * Clock.MICROS_PER_SECOND;

  /**
   * A clear given for other stops does not lift one that arrived so shortly before it [µs]: who
   * cleared cannot have known that.
   */
  private static final long UNKNOWN_MICROS = Clock.MICROS_PER_SECOND / 2;

  private static final long LONG_AGO_MICROS = Long.MIN_VALUE / 2;

  private static final String STANDING = "EMERGENCY STOPS";
  private static final String LIFTED = "LIFTED EMERGENCY STOPS";
  private static final String LIFTED_TIMES = "TIMES OF LIFTED EMERGENCY STOPS";
  private static final String CLEAR_TIMES = "TIMES OF CLEARS";
  private static final String CLEARS = "CLEARS";
  private static final String UNTIMED = "EMERGENCY STOPS WITHOUT A TIME";

  /**
   * @param saidMicros timestamp of the stop; empty if unknown
   * @param liftedMicros time of the clear [µs of this clock]
   */
  private record Lifted(OptionalLong saidMicros, long liftedMicros) {}

  /**
   * @param arrivedMicros when it was given, or given again under its ID [µs of this clock]
   * @param isAgain whether it was given again, with another timestamp
   */
  private record Held(EmergencyStop stop, long arrivedMicros, boolean isAgain) {}

  private final Clock clock;
  private final String systemId;
  private final Map<String, Held> standing = new LinkedHashMap<>(); // by identity
  private final List<EmergencyStop> spared = new ArrayList<>(); // by the last clear
  private final Set<String> untimed = new HashSet<>(); // stops without a timestamp
  private final Map<String, Lifted> lifted = new LinkedHashMap<>(); // by identity, the oldest first
  private final ObeyedOrders clears = new ObeyedOrders();
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
   * Processes a stop or a clear; returns whether the first stop was set or the last one cleared. A
   * repeat of a cleared stop, from a sender that has not received the clear yet, is ignored.
   */
  public boolean accept(EmergencyStop message) {
    boolean before = isStopped();
    if (message.active()) {
      latch(message);
    } else if (isOwn(message) && clears.add("", message)) {
      lift(message);
    }
    return isStopped() != before;
  }

  private boolean isOwn(EmergencyStop clear) {
    return clear.systemId().isEmpty() || clear.systemId().equals(systemId);
  }

  private void latch(EmergencyStop message) {
    EmergencyStop stop = message.timestamp().isPresent() ? message : stamped(message);
    if (!isRepeatOfLifted(stop.identity(), message.timestamp())) {
      hold(stop, message.timestamp().isEmpty(), clock.micros());
    }
  }

  private void hold(EmergencyStop stop, boolean isUntimed, long arrivedMicros) {
    String identity = stop.identity();
    Held before = standing.get(identity);
    boolean wasUntimed = untimed.contains(identity);
    long said = micros(stop);
    if (before != null && (isUntimed || said == micros(before.stop()))) {
      return;
    }
    if (before != null || standing.size() < TOLD_APART) {
      boolean isNewer = before == null || said > micros(before.stop());
      EmergencyStop counting = isNewer ? stop : before.stop(); // for clears up to a time
      boolean isSame = before != null && wasUntimed; // repeated with the time of who received it
      standing.put(
          identity,
          isSame
              ? new Held(counting, before.arrivedMicros(), before.isAgain())
              : new Held(counting, arrivedMicros, before != null));
      if (!isNewer) {
        return;
      }
      if (isUntimed) {
        untimed.add(identity);
      } else {
        untimed.remove(identity);
      }
    } else if (beyond == null || micros(stop) > micros(beyond)) {
      beyond = stop;
    }
  }

  /**
   * Repeats keep the timestamp; another timestamp means another stop, even with the same ID. If
   * either has no timestamp, only a stop soon after the clear counts as a repeat.
   */
  private boolean isRepeatOfLifted(String identity, OptionalLong saidMicros) {
    Lifted before = lifted.get(identity);
    if (before == null) {
      return false;
    }
    if (saidMicros.isEmpty() || before.saidMicros().isEmpty()) {
      long sinceMicros = clock.micros() - before.liftedMicros();
      return sinceMicros >= 0 && sinceMicros <= REPEATED_MICROS; // negative: the clock was set back
    }
    return before.saidMicros().equals(saidMicros);
  }

  /** Makes a repeat, and the clear with its ID, match this stop. */
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
    spared.clear();
    Iterator<Held> stops = standing.values().iterator();
    while (stops.hasNext()) {
      Held held = stops.next();
      EmergencyStop stop = held.stop();
      boolean isMeant =
          names.isEmpty() ? micros(stop) <= untilMicros : names.contains(stop.identity());
      boolean isExact = names.isEmpty() ? micros(stop) == untilMicros : !held.isAgain();
      if (isMeant && (isExact || !isUnknown(held))) {
        stops.remove();
        remember(stop);
      } else if (isMeant) {
        spared.add(stop);
      }
    }
    if (beyond != null && micros(beyond) <= untilMicros) {
      beyond = null;
    }
  }

  /**
   * Gives a standing stop a new timestamp, so that services that have lifted it stop again; returns
   * the stop to publish.
   */
  public EmergencyStop renew(EmergencyStop stop) {
    EmergencyStop again = stamped(stop);
    Held held = standing.get(stop.identity());
    if (held == null) { // beyond those told apart
      hold(again, false, clock.micros());
    } else {
      untimed.remove(stop.identity());
      standing.put(again.identity(), new Held(again, held.arrivedMicros(), held.isAgain()));
    }
    return again;
  }

  /** Whether nobody who clears now can have known the stop. */
  private boolean isUnknown(Held held) {
    long sinceMicros = clock.micros() - held.arrivedMicros();
    return sinceMicros >= 0 && sinceMicros < UNKNOWN_MICROS; // negative: the clock was set back
  }

  /** Stops that the last clear covers by its words, but that were given just before it. */
  public List<EmergencyStop> spared() {
    return List.copyOf(spared);
  }

  private void remember(EmergencyStop stop) {
    OptionalLong said = untimed.remove(stop.identity()) ? OptionalLong.empty() : stop.timestamp();
    lifted.remove(stop.identity()); // so that it comes last
    lifted.put(stop.identity(), new Lifted(said, clock.micros()));
    if (lifted.size() > 2 * TOLD_APART) {
      Iterator<String> oldest = lifted.keySet().iterator();
      oldest.next();
      oldest.remove();
    }
  }

  public boolean isStopped() {
    return !standing.isEmpty() || beyond != null;
  }

  /** The newest active stop. */
  public Optional<EmergencyStop> stop() {
    return stops().stream().reduce((one, other) -> micros(other) >= micros(one) ? other : one);
  }

  /** All active tracked stops, in order of arrival. */
  public List<EmergencyStop> stops() {
    List<EmergencyStop> stops = new ArrayList<>();
    standing.values().forEach(held -> stops.add(held.stop()));
    if (beyond != null) {
      stops.add(beyond);
    }
    return stops;
  }

  /** {@link EmergencyStop#identity()} of the active stops. */
  public List<String> identities() {
    List<String> identities = new ArrayList<>();
    stops().forEach(stop -> identities.add(stop.identity()));
    return Collections.unmodifiableList(identities);
  }

  /** Saves the active and the lifted stops. */
  public void handOver(HandOver state) {
    List<String> times = new ArrayList<>();
    List<String> liftTimes = new ArrayList<>();
    for (Lifted each : lifted.values()) {
      times.add(text(each.saidMicros()));
      liftTimes.add(Long.toString(each.liftedMicros()));
    }
    state
        .messages(STANDING, stops())
        .texts(UNTIMED, untimed)
        .texts(LIFTED, lifted.keySet())
        .texts(LIFTED_TIMES, times)
        .texts(CLEAR_TIMES, liftTimes)
        .texts(CLEARS, clears.identities());
  }

  /** Restores the saved state; without it, starts with no stop. */
  public void takeOver(HandOver state) {
    List<String> identities = state.texts(LIFTED);
    List<String> times = state.texts(LIFTED_TIMES); // these two: none from an earlier version
    List<String> liftTimes = state.texts(CLEAR_TIMES);
    for (int i = 0; i < identities.size(); i++) {
      OptionalLong said = i < times.size() ? micros(times.get(i)) : OptionalLong.empty();
      OptionalLong clear = i < liftTimes.size() ? micros(liftTimes.get(i)) : OptionalLong.empty();
      lifted.put(identities.get(i), new Lifted(said, clear.orElse(LONG_AGO_MICROS)));
    }
    clears.takeOver(state.texts(CLEARS));
    List<String> withoutTime = state.texts(UNTIMED);
    state
        .messages(STANDING, EmergencyStop.class)
        .forEach(stop -> hold(stop, withoutTime.contains(stop.identity()), LONG_AGO_MICROS));
  }

  private static String text(OptionalLong micros) {
    return micros.isPresent() ? Long.toString(micros.getAsLong()) : "";
  }

  private static OptionalLong micros(String text) {
    return text.isEmpty() ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(text));
  }
}
