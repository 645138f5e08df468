package org.u2sa.gcs.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

/**
 * Tracks which services confirm an emergency stop. A stop is confirmed once every service that
 * obeys stops reports it as active.
 */
public final class StopConfirmation {
  /** Time for two reports of a service with the default report period. */
  private static final double LISTEN_S = 0.6;

  private final RemoteLink link;
  private final String systemId;
  private final Clock.Waiter waiter;
  private final Map<String, List<String>> holding = new TreeMap<>(); // by service; guarded by this
  private final Set<String> heard = new TreeSet<>(); // guarded by this
  private final Map<String, String> broken = new TreeMap<>(); // guarded by this
  private final Map<String, EmergencyStop> stops = new TreeMap<>(); // by identity; guarded by this

  private StopConfirmation(RemoteLink link, String systemId, Clock.Waiter waiter) {
    this.link = link;
    this.systemId = systemId;
    this.waiter = waiter;
  }

  /**
   * Starts listening.
   *
   * @param link to that system, or to all
   * @param waiter signalled with each relevant message of that system
   */
  public static StopConfirmation listen(RemoteLink link, String systemId, Clock.Waiter waiter) {
    StopConfirmation confirmation = new StopConfirmation(link, systemId, waiter);
    link.listen(Channels.HEALTH, confirmation.<HealthReport>taking(confirmation::take));
    link.listen(Channels.CONDITIONS, confirmation.<ServiceCondition>taking(confirmation::take));
    link.listen(Channels.EMERGENCY_STOP, confirmation.<EmergencyStop>taking(confirmation::take));
    return confirmation;
  }

  /** Runs the action on the transport's thread, and re-evaluates. */
  private <T extends U2SAData> Consumer<T> taking(Consumer<T> action) {
    return message -> {
      if (!message.systemId().equals(systemId)) {
        return;
      }
      synchronized (this) {
        action.accept(message);
      }
      waiter.signal();
    };
  }

  private void take(HealthReport report) {
    if (report.status() == ServiceStatus.STOPPED) {
      heard.remove(report.serviceName());
      holding.remove(report.serviceName());
      return;
    }
    heard.add(report.serviceName());
    report.emergencyStops().ifPresent(held -> holding.put(report.serviceName(), held));
  }

  private void take(ServiceCondition condition) {
    switch (condition.condition()) {
      case HUNG, DEAD, LOST, FAILED ->
          broken.put(condition.serviceName(), condition.condition() + ": " + condition.reason());
      default -> broken.remove(condition.serviceName());
    }
  }

  private void take(EmergencyStop stop) {
    if (stop.active()) {
      stops.put(stop.identity(), stop);
    }
  }

  /** Waits until all services have reported twice, or longer for the vehicle's first message. */
  public void await(Outcome wanted) throws InterruptedException {
    long begun = link.clock().micros();
    long least = begun + Clock.micros(Math.min(LISTEN_S, link.timeoutS()));
    long most = begun + Clock.micros(link.timeoutS());
    while (link.clock().micros() < least
        || !missing(wanted).isEmpty() && link.clock().micros() < most) {
      waiter.await(link.clock().micros() < least ? least : most);
    }
  }

  /** Condition on the stops in force at a service. */
  public interface Outcome {
    boolean isSaid(List<String> holding);
  }

  /** Services that obey stops and satisfy the condition. */
  public synchronized List<String> confirmedBy(Outcome wanted) {
    List<String> by = new ArrayList<>();
    holding.forEach(
        (service, held) -> {
          if (wanted.isSaid(held)) {
            by.add(service);
          }
        });
    return by;
  }

  /** Reasons why the vehicle does not satisfy the condition, one text each; empty if it does. */
  public synchronized List<String> missing(Outcome wanted) {
    List<String> missing = new ArrayList<>();
    if (heard.isEmpty()) {
      missing.add("no service of system \"" + systemId + "\" is heard");
    } else if (holding.isEmpty()) {
      missing.add("of its " + heard.size() + " services, none reports obeying emergency stops");
    }
    holding.forEach(
        (service, held) -> {
          if (!wanted.isSaid(held)) {
            missing.add(
                service + (held.isEmpty() ? " is not stopped" : " is stopped by " + words(held)));
          }
        });
    broken.forEach(
        (service, how) -> {
          if (!confirmed(service, wanted)) {
            missing.add(service + " does not answer: it is " + how);
          }
        });
    return missing;
  }

  private boolean confirmed(String service, Outcome wanted) {
    List<String> held = holding.get(service);
    return held != null && wanted.isSaid(held);
  }

  private String words(List<String> held) {
    List<String> words = new ArrayList<>();
    for (String identity : held) {
      EmergencyStop stop = stops.get(identity);
      words.add(
          stop == null ? "the stop " + identity : "\"" + stop.operator() + "\": " + stop.reason());
    }
    return String.join(", ", words);
  }

  /** Whether any service of the system has been heard. */
  public synchronized boolean hearsAnybody() {
    return !heard.isEmpty();
  }

  /** All stops in force at any service or retained by the broker. */
  public synchronized Set<String> standing() {
    Set<String> all = new TreeSet<>(stops.keySet());
    holding.values().forEach(all::addAll);
    return all;
  }

  /** Time of the latest stop received [µs]; 0 if none. */
  public synchronized long newestMicros() {
    return stops.values().stream().mapToLong(stop -> stop.timestamp().orElse(0L)).max().orElse(0L);
  }
}
