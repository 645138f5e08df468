package org.u2sa.benchmarks.chain;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.ToLongFunction;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** What the services said last of themselves. */
final class HealthWatch extends EventDrivenService {
  private final Map<String, HealthReport> newest = new ConcurrentHashMap<>(); // by service

  HealthWatch(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "HealthWatch");
    subscribe(Channels.HEALTH, report -> newest.put(report.serviceName(), report));
  }

  /** The sum of a count over all services. */
  long sum(ToLongFunction<HealthReport> count) {
    return newest.values().stream().mapToLong(count).sum();
  }
}
