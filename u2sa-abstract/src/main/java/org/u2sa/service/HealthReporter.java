package org.u2sa.service;

import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * Reports a service's health (thesis 3.5.3): its own periodic reports, and substitute reports for
 * others to publish when it is silent.
 */
final class HealthReporter {
  /** Number of missed intervals after which a service counts as silent. */
  private static final long SILENT_AFTER = 3;

  private final U2SAService service;
  private final long intervalMicros;
  private long dueMicros = Long.MIN_VALUE; // touched by the service's thread only
  private volatile long reportedMicros = Long.MIN_VALUE;
  private volatile boolean lastSaid;

  HealthReporter(U2SAService service, double intervalS) {
    this.service = service;
    intervalMicros = Clock.micros(intervalS);
  }

  /** Time of the next report [µs]. */
  long dueMicros() {
    return dueMicros;
  }

  /** Reports if due, and returns whether it was. Called on the service's thread. */
  boolean reportIfDue(long nowMicros) {
    if (nowMicros < dueMicros) {
      return false;
    }
    service.publish(Channels.HEALTH, report());
    reportedMicros = nowMicros;
    dueMicros = nowMicros + intervalMicros;
    return true;
  }

  /** Makes a report due before the next message is handled. Called on the service's thread. */
  void reportSoon() {
    dueMicros = Long.MIN_VALUE;
  }

  /** Reports that the service has ended. */
  void reportLast() {
    HealthReport last = report();
    if (service.health.hasDied()) {
      last.threadAlive(false);
    }
    lastSaid = service.publish(Channels.HEALTH, last);
  }

  /**
   * Substitute report if the service's own is overdue; empty if it reports itself, has not been
   * started, or has sent its last report.
   */
  Optional<HealthReport> onBehalf(long nowMicros) {
    Thread handling = service.loop == null ? service : service.loop.messages();
    Thread.State state = handling.getState(); // first: an ended thread has reported its end
    if (service.status() == ServiceStatus.CREATED || lastSaid) {
      return Optional.empty();
    }
    boolean alive = state != Thread.State.TERMINATED;
    long heardMicros = Math.max(service.life.startedMicros(), reportedMicros);
    if (alive && nowMicros - heardMicros < SILENT_AFTER * intervalMicros) {
      return Optional.empty();
    }
    HealthReport report = report().threadAlive(alive);
    service.health.runningS().ifPresent(report::callbackRunning);
    return Optional.of(report);
  }

  private HealthReport report() {
    HealthReport report =
        new HealthReport()
            .serviceName(service.getName())
            .status(service.status())
            .interval(Clock.seconds(intervalMicros))
            .inboxDepth(service.handling.inbox().depth())
            .dropped(service.handling.inbox().dropped())
            .replaced(service.handling.inbox().replaced())
            .refused(service.wiring.refused())
            .missed(service.wiring.missed())
            .published(service.wiring.published());
    service.wiring.instance().ifPresent(report::instance);
    service.wiring.dataAgeS().ifPresent(report::dataAge);
    Set<String> deafTo = service.wiring.refusedSubscriptions();
    if (!deafTo.isEmpty()) {
      report.refusedSubscriptions(String.join(",", deafTo));
    }
    return service.health.addTo(report);
  }
}
