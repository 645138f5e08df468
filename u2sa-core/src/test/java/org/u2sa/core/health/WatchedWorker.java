package org.u2sa.core.health;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.testkit.ServiceKit;

/** Tests of a HealthMonitor that watches one service, which reports what the test says. */
abstract class WatchedWorker {
  static final double INTERVAL_S = 0.25;

  final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  HealthMonitor monitor() {
    return kit.with("WATCHED", "Worker").start(HealthMonitor::new);
  }

  static HealthReport report(String instance) {
    return new HealthReport()
        .serviceName("Worker")
        .status(ServiceStatus.RUNNING)
        .instance(instance)
        .interval(INTERVAL_S)
        .published(0);
  }

  void say(HealthReport report) {
    kit.publish(Channels.HEALTH, report);
  }

  /** Reports all is well for a while. */
  void live(String instance, double forS) {
    for (double s = 0.0; s < forS; s += INTERVAL_S) {
      say(report(instance));
      kit.advance(INTERVAL_S);
    }
  }

  ServiceCondition condition() {
    return kit.latest(Channels.CONDITIONS).orElseThrow();
  }

  List<Condition> conditions() {
    return kit.published(Channels.CONDITIONS).stream()
        .map(ServiceCondition::condition)
        .distinct()
        .collect(Collectors.toList());
  }

  List<ServiceOrder> orders() {
    return kit.published(Channels.SERVICE_ORDERS).stream()
        .filter(ServiceOrder.class::isInstance)
        .map(ServiceOrder.class::cast)
        .collect(Collectors.toList());
  }

  void answer(ServiceOrder order, boolean accepted) {
    answer(order, accepted, accepted ? "" : "no device");
  }

  void answer(ServiceOrder order, boolean accepted, String reason) {
    kit.publish(
        Channels.SERVICE_ORDERS,
        new ServiceOrderResult()
            .requestId(order.requestId())
            .serviceName("Worker")
            .accepted(accepted)
            .reason(reason));
  }
}
