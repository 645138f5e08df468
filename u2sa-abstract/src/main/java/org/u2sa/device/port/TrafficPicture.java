package org.u2sa.device.port;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;

/**
 * The latest report of each target, for receivers that report one target at a time. Not
 * thread-safe.
 */
public final class TrafficPicture {
  private static final long FORGOTTEN_AFTER_MICROS = Clock.micros(60.0);
  private static final int MOST = 1_000; // caps memory against spoofed traffic

  private final Map<String, TrafficTarget> targets = new TreeMap<>();
  private Optional<TrafficReceiver.Traffic> latest = Optional.empty();

  /**
   * Adds a report; a new target is ignored if there are already a thousand.
   *
   * @param nowMicros time of the run's clock [µs], never less than at the last call
   */
  public void heard(TrafficTarget target, long nowMicros) {
    targets.values().removeIf(each -> nowMicros - each.heardAtMicros() > FORGOTTEN_AFTER_MICROS);
    if (targets.size() < MOST || targets.containsKey(target.id())) {
      targets.put(target.id(), target);
    }
    alive(nowMicros);
  }

  /** Refreshes the list without changes after a sign of life from the receiver. */
  public void alive(long nowMicros) {
    latest = Optional.of(new TrafficReceiver.Traffic(nowMicros, List.copyOf(targets.values())));
  }

  public Optional<TrafficReceiver.Traffic> latest() {
    return latest;
  }
}
