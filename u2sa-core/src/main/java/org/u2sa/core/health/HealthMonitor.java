package org.u2sa.core.health;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Monitors the services and orders restarts of failed ones (thesis 3.5.3). In: health, including
 * the wills of broken connections; stop; service-orders (results); conditions (of a previous
 * monitor); arming-state and failsafe of the Safety Manager. Out: conditions, at each change;
 * service-orders; failsafe, while the Safety Manager of an armed vehicle is lost.
 *
 * <p>It distinguishes hung, dead, lost, stalled, failed, silent and stopped services. Each service
 * has its own policy. The monitor itself is watched by its process's {@code HealthWatch} or its
 * supervisor. While it is disconnected from all others, it does not judge any service. It reports
 * by name the services whose clocks differ from its own.
 */
public final class HealthMonitor extends PeriodicService {
  private static final double LOOKS_PER_S = 4.0;
  private static final double SLOWEST_HZ = 1.0; // otherwise failsafes would come too late

  /** Steps the monitor itself may miss before it stops treating silence as evidence. */
  private static final double LOST_AFTER_PERIODS = 4.0;

  private static final int MAX_NAMES = 500; // so that invented names do not fill the memory

  private final Map<String, WatchedService> services = new TreeMap<>();
  private final Set<String> reported = new TreeSet<>(); // services, watched or not
  private final Settings<MonitorVariables.Limits> limits = settings(MonitorVariables.Limits.class);
  private MonitorVariables settings;
  private final ReceptionCheck reception;
  private final ClockOffsets clocks = new ClockOffsets();
  private final SafetyManagerLoss safetyManager;
  private boolean demands; // a failsafe on behalf of the Safety Manager
  private double lookedS = Double.NaN;
  private long orders;

  public HealthMonitor(ServiceContext context) {
    super(context, ServiceRole.HEALTH_MONITOR, "HealthMonitor", LOOKS_PER_S, SLOWEST_HZ);
    settings = new MonitorVariables(limits.get(), this);
    reception = new ReceptionCheck(nowS());
    registerPublisher(Channels.CONDITIONS);
    registerPublisher(Channels.SERVICE_ORDERS);
    registerPublisher(Channels.FAILSAFE);
    safetyManager = new SafetyManagerLoss(context.isRestart() || context.isSwap());
    subscribe(Channels.ARMING_STATE, state -> safetyManager.hear(state, clock().micros()));
    subscribe(Channels.FAILSAFE, safetyManager::hear);
    subscribe(Channels.CONDITIONS, this::remember);
    subscribe(Channels.HEALTH, this::hear);
    subscribe(
        Channels.STOP,
        stop -> stop.serviceName().flatMap(this::known).ifPresent(WatchedService::toldToStop));
    subscribe(Channels.SERVICE_ORDERS, this::onOrder);
  }

  @Override
  protected void begin() {
    settings.watched.forEach(this::service);
  }

  /** Rejects impossible names in WATCHED and, while the vehicle is armed, names unheard so far. */
  @Override
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    String watched = (String) values.get(MonitorVariables.WATCHED);
    Optional<String> refusal = MonitorVariables.nameRefusal(watched);
    return refusal.isPresent() || !safetyManager.isArmed()
        ? refusal
        : MonitorVariables.unknown(watched, reported);
  }

  @Override
  protected void configurationChanged(Set<String> variableNames) {
    settings = new MonitorVariables(limits.get(), this);
    services.keySet().stream().filter(name -> !settings.watches(name)).forEach(this::unwatch);
    services.keySet().removeIf(name -> !settings.watches(name));
    settings.watched.forEach(this::service);
  }

  private WatchedService service(String name) {
    return services.computeIfAbsent(name, key -> new WatchedService(key, nowS()));
  }

  private Optional<WatchedService> known(String name) {
    return Optional.ofNullable(services.get(name));
  }

  private boolean watches(String name) {
    return settings.watches(name) && !name.equals(getServiceName());
  }

  private void hear(HealthReport report) {
    boolean forItself = report.threadAlive().isEmpty() && !(report instanceof ConnectionLost);
    if (report.serviceName().equals(getServiceName()) && forItself) {
      reception.hear(report, nowS());
    } else if (forItself) {
      clocks.hear(report, clock().micros(), limits.get().clockTolerance()).ifPresent(this::trouble);
    }
    if (reported.size() < MAX_NAMES) {
      reported.add(report.serviceName());
    }
    if (!watches(report.serviceName())) {
      return;
    }
    WatchedService service = service(report.serviceName());
    service.hear(report, nowS());
    if (report.status() != ServiceStatus.RUNNING || report.threadAlive().isPresent()) {
      look(service); // immediately, not at the next step
    }
  }

  private void onOrder(U2SAData message) { // orders share this channel
    if (message instanceof ServiceOrderResult result) {
      onResult(result);
    }
  }

  private void onResult(ServiceOrderResult result) {
    Optional<WatchedService> service = known(result.serviceName());
    if (service.isEmpty()) {
      return;
    }
    if (result.requestId().startsWith(requestPrefix())) {
      service.get().answered(result.accepted(), result.reason(), nowS());
      if (!result.accepted()) {
        log(LogLevelEnum.ERROR, result.serviceName() + " not restarted: " + result.reason());
      }
    } else if (result.accepted()) {
      service.get().startedByOthers();
    } else {
      service.get().notStarted(result.reason());
    }
  }

  private String requestPrefix() {
    return getServiceName() + " " + getThreadID() + " ";
  }

  /** Restores a retained condition of an earlier monitor; also receives this one's own. */
  private void remember(ServiceCondition before) {
    if (watches(before.serviceName())) {
      service(before.serviceName()).remember(before);
    } else if (!settings.watches(before.serviceName())
        && before.condition() != Condition.UNWATCHED) {
      unwatch(before.serviceName());
    }
  }

  /** Withdraws the retained condition of a service, which would otherwise stay valid forever. */
  private void unwatch(String name) {
    log(name + " is no longer watched");
    publish(
        Channels.CONDITIONS,
        new ServiceCondition().serviceName(name).condition(Condition.UNWATCHED));
  }

  @Override
  protected void step(double nowS) {
    if (nowS - lookedS > LOST_AFTER_PERIODS * periodS()) {
      log(
          LogLevelEnum.WARN,
          String.format(
              Locale.ROOT,
              "no check for %.1f s: not judging services by their silence",
              nowS - lookedS));
      services.values().forEach(service -> service.excuse(nowS));
      safetyManager.excuse(nowS);
    }
    lookedS = nowS;
    if (hears(nowS)) {
      services.values().forEach(this::look);
      replaceSafetyManager(nowS);
    }
  }

  private void replaceSafetyManager(double nowS) {
    boolean isLost = safetyManager.isLost(limits.get(), nowS);
    if (isLost != demands) {
      demands = isLost;
      log(
          isLost ? LogLevelEnum.ERROR : LogLevelEnum.INFO,
          isLost
              ? "the Safety Manager of an armed vehicle is silent: failsafe "
                  + limits.get().onSafetyManagerLoss()
              : "the Safety Manager reports again");
    }
    safetyManager.due(limits.get(), nowS).ifPresent(this::publish);
  }

  private boolean hears(double nowS) {
    ReceptionCheck.Change change = reception.look(nowS);
    if (change == ReceptionCheck.Change.LOST) {
      log(
          LogLevelEnum.WARN,
          "does not receive even its own reports: not judging any service until it does");
    } else if (change == ReceptionCheck.Change.RESTORED) {
      log(LogLevelEnum.WARN, "receives reports again");
      services.values().forEach(service -> service.excuse(ReceptionCheck.excusedUntilS(nowS)));
      safetyManager.excuse(ReceptionCheck.excusedUntilS(nowS));
    }
    return change == ReceptionCheck.Change.NONE || change == ReceptionCheck.Change.RESTORED;
  }

  private void look(WatchedService service) {
    if (service.look(settings, nowS())) {
      order(service.name());
    }
    service.news().ifPresent(this::say);
  }

  private void order(String name) {
    publish(
        Channels.SERVICE_ORDERS,
        new ServiceOrder()
            .requestId(requestPrefix() + clock().micros() + " " + ++orders)
            .serviceName(name)
            .action(ServiceAction.RESTART)
            .operator(getServiceName()));
  }

  private void say(ServiceCondition condition) {
    boolean well =
        condition.condition() == Condition.ALIVE || condition.condition() == Condition.STOPPED;
    String because = condition.reason().isEmpty() ? "" : ": " + condition.reason();
    String then = condition.action().isEmpty() ? "" : "; " + condition.action();
    log(
        well ? LogLevelEnum.INFO : LogLevelEnum.WARN,
        condition.serviceName() + " is " + condition.condition() + because + then);
    publish(Channels.CONDITIONS, condition);
  }
}
