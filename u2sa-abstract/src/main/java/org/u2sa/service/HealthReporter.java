package org.u2sa.service;

import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * Reports a service's health (thesis 3.5.3) periodically, and provides substitute reports while the
 * service is silent.
 */
final class HealthReporter {
  /** Missed intervals after which a service counts as silent. */
  private static final long SILENT_AFTER = 3;

  private final ServiceReceiver.Recipient service;
  private final ServiceConnection connection;
  private final ServiceHealth health;
  private final Thread handling;
  private final long intervalMicros;
  private long dueMicros = Long.MIN_VALUE; // touched by the service's thread only
  private volatile long reportedMicros = Long.MIN_VALUE;
  private volatile boolean lastSaid;

  /**
   * @param handling thread that handles the service's messages
   */
  HealthReporter(
      ServiceReceiver.Recipient service,
      ServiceConnection connection,
      ServiceHealth health,
      Thread handling) {
    this.service = service;
    this.connection = connection;
    this.health = health;
    this.handling = handling;
    intervalMicros = Clock.micros(service.configuration().settings().healthInterval());
  }

  long dueMicros() {
    return dueMicros;
  }

  /** Returns whether it reported. */
  boolean reportIfDue(long nowMicros) {
    if (nowMicros < dueMicros) {
      return false;
    }
    connection.publish(Channels.HEALTH, report());
    reportedMicros = nowMicros;
    dueMicros = nowMicros + intervalMicros;
    return true;
  }

  /** Requests a report before the next message is handled. */
  void reportSoon() {
    dueMicros = Long.MIN_VALUE;
  }

  void reportLast() {
    HealthReport last = report();
    if (health.hasDied()) {
      last.threadAlive(false);
    }
    lastSaid = connection.publish(Channels.HEALTH, last);
  }

  /**
   * Substitute report; empty if the service reports itself, has not been started, or has sent its
   * last report.
   */
  Optional<HealthReport> onBehalf(long nowMicros) {
    Thread.State state = handling.getState(); // first: an ended thread has reported its end
    if (service.life().status() == ServiceStatus.CREATED || lastSaid) {
      return Optional.empty();
    }
    boolean alive = state != Thread.State.TERMINATED;
    long heardMicros = Math.max(service.life().startedMicros(), reportedMicros);
    if (alive && nowMicros - heardMicros < SILENT_AFTER * intervalMicros) {
      return Optional.empty();
    }
    HealthReport report = report().threadAlive(alive);
    health.runningS().ifPresent(report::callbackRunning);
    return Optional.of(report);
  }

  private HealthReport report() {
    HealthReport report =
        new HealthReport()
            .serviceName(service.configuration().name())
            .status(service.life().status())
            .interval(Clock.seconds(intervalMicros))
            .inboxDepth(service.inbox().depth())
            .dropped(service.inbox().dropped())
            .replaced(service.inbox().replaced())
            .refused(connection.refused())
            .missed(connection.missed())
            .published(connection.published());
    connection.instance().ifPresent(report::instance);
    connection.dataAgeS().ifPresent(report::dataAge);
    Set<String> deafTo = connection.refusedSubscriptions();
    if (!deafTo.isEmpty()) {
      report.refusedSubscriptions(String.join(",", deafTo));
    }
    health.remark("log", service.configuration().log().trouble());
    return health.addTo(report);
  }
}
