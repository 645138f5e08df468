package org.u2sa.core.launch;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/**
 * Reports on behalf of silent services of this process (thesis 3.5.3): publishes on {@code health}
 * whether the thread is alive and how long its callback has been running. One thread per process,
 * on the run's clock; it only checks and publishes.
 *
 * <p>It also restarts a dead or hung health monitor, which nothing else would do.
 */
final class HealthWatch implements AutoCloseable {
  private static final long EVERY_MICROS = 250_000;
  private static final double HUNG_AFTER_S = 2.0;
  private static final long AWAY_AFTER_MICROS = 4_000_000;
  private static final long RESTART_AT_MOST_EVERY_MICROS = 5_000_000;

  private final Clock clock;
  private final Clock.Waiter waiter;
  private final Supplier<List<U2SAService>> services;
  private final Launcher launcher;
  private final Thread thread = new Thread(this::run, "u2sa-health-watch");
  private long spokeMicros; // last report by the monitor itself
  private long restartedMicros = Long.MIN_VALUE;
  private long failures;
  private volatile boolean closed;

  /**
   * @param services current services of the process
   * @param launcher publishes the reports
   */
  HealthWatch(Clock clock, Supplier<List<U2SAService>> services, Launcher launcher) {
    this.clock = clock;
    this.services = services;
    this.launcher = launcher;
    waiter = clock.newWaiter(thread.getName());
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  private void run() {
    try {
      spokeMicros = clock.micros();
      waiter.lend(new Looks());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      waiter.close();
    }
  }

  /**
   * Checks all services in each turn except the first, which only synchronises with the other
   * threads.
   */
  private final class Looks implements Clock.Turns {
    private boolean hasJoined;

    @Override
    public long take() {
      if (closed) {
        return OVER;
      }
      long dueMicros = clock.micros();
      if (hasJoined) {
        services.get().forEach(HealthWatch.this::lookAt);
        dueMicros += EVERY_MICROS;
      }
      hasJoined = true;
      return dueMicros;
    }
  }

  /** Checks a service; an error in one, including out of memory, does not affect the others. */
  private void lookAt(U2SAService service) {
    try {
      look(service);
    } catch (RuntimeException | OutOfMemoryError e) {
      if (Long.bitCount(++failures) == 1) { // 1st, 2nd, 4th, 8th…: checks run four times a second
        launcher.trouble(
            String.format(
                "watching %s failed: %s (%s so far)", service.getServiceName(), e, failures));
      }
    }
  }

  private void look(U2SAService service) {
    Optional<HealthReport> overdue = service.overdueHealth();
    overdue.ifPresent(report -> launcher.publish(Channels.HEALTH, report));
    if (service.role() == ServiceRole.HEALTH_MONITOR) {
      if (isHung(overdue) || service.status() == ServiceStatus.FAILED) {
        restart(service);
      }
    }
  }

  /** Whether the monitor is stuck, in a callback or elsewhere. */
  private boolean isHung(Optional<HealthReport> monitorsOverdue) {
    if (monitorsOverdue.isEmpty()) {
      spokeMicros = clock.micros();
      return false;
    }
    return monitorsOverdue.get().callbackRunning().orElse(0) > HUNG_AFTER_S
        || clock.micros() - spokeMicros > AWAY_AFTER_MICROS;
  }

  private void restart(U2SAService monitor) {
    long now = clock.micros();
    if (restartedMicros != Long.MIN_VALUE && now - restartedMicros < RESTART_AT_MOST_EVERY_MICROS) {
      return;
    }
    restartedMicros = now;
    launcher.publish(
        Channels.SERVICE_ORDERS,
        new ServiceOrder()
            .requestId(thread.getName() + " " + now)
            .serviceName(monitor.getServiceName())
            .action(ServiceAction.RESTART)
            .operator(launcher.getServiceName()));
  }

  /** Ends the thread; returns when it has ended. */
  @Override
  public void close() {
    closed = true;
    waiter.close();
    try {
      thread.join(); // returns immediately if never started
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
