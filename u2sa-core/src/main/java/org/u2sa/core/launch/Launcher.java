package org.u2sa.core.launch;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.AnsweredOrders;

/**
 * Starts, restarts and swaps the services of its process on order (thesis 3.5.3, user story 8). In:
 * service-orders. Out: service-orders, the results; health, on behalf of services that are silent.
 *
 * <p>It is not listed in the system file: {@link RunningSystem} creates one for each process that
 * hosts services, named {@code Launcher}, or {@code Launcher-<service>} in a process that runs one
 * of several services. Orders are carried out by its {@link ServiceHost}; for services of the same
 * process that is {@link HostedServices}.
 *
 * <p>A result is published when the order has been carried out. Orders for services of other hosts
 * are left to their launchers. A repeated order is answered again but not executed again.
 */
public final class Launcher extends EventDrivenService {
  /** Name of a system's only launcher, and prefix of the names of several. */
  public static final String NAME = "Launcher";

  private static final double BETWEEN_S = 1.0; // two orders of one kind for one service
  private static final long NEVER = Long.MIN_VALUE / 2;
  private static final String ANSWERED = "ANSWERED ORDERS";

  private final ServiceHost host;
  private final Map<String, Long> doneMicros = new HashMap<>(); // by kind of order
  private final AnsweredOrders<ServiceOrderResult> answered = new AnsweredOrders<>();

  /**
   * Created by the process that hosts the services.
   *
   * @param name {@link #NAME}, or with the hosted service's name after a hyphen
   */
  public Launcher(ServiceContext context, String name, ServiceHost host) {
    super(context, ServiceRole.LAUNCHER, name);
    this.host = host;
    registerPublisher(Channels.SERVICE_ORDERS);
    registerPublisher(Channels.HEALTH);
    subscribe(Channels.SERVICE_ORDERS, this::onOrder);
  }

  private void onOrder(U2SAData message) { // results come back on the same channel
    if (message instanceof ServiceOrder order && host.isFor(order)) {
      Optional<ServiceOrderResult> before = answered.to(order.requestId(), order);
      if (before.isPresent()) {
        publish(Channels.SERVICE_ORDERS, before.get());
        return;
      }
      Optional<String> refusal = outcomeOf(order);
      if (refusal.isEmpty()) {
        doneMicros.put(kindOf(order), clock().micros());
      }
      answer(order, refusal);
    }
  }

  /**
   * Why the order failed; empty if it did not. Also catches errors, such as a lack of memory for
   * the new service, because without the launcher no service of the process could be restarted.
   */
  private Optional<String> outcomeOf(ServiceOrder order) {
    try {
      return carryOut(order);
    } catch (RuntimeException | Error e) {
      return Optional.of("it failed: " + e);
    }
  }

  private Optional<String> carryOut(ServiceOrder order) {
    String service = order.serviceName();
    Optional<String> refusal = tooSoon(order);
    if (refusal.isPresent()) {
      return refusal;
    }
    log("ordered by \"" + order.operator() + "\": " + order.action() + " " + service);
    return switch (order.action()) {
      case START -> host.start(service);
      case RESTART -> host.restart(service);
      case SWAP ->
          order
              .className()
              .map(className -> host.swap(service, className))
              .orElse(Optional.of("className: missing; expected the full name of a service class"));
      default -> Optional.of("action " + order.action() + " is unknown here");
    };
  }

  private static String kindOf(ServiceOrder order) {
    return order.action() + " " + order.serviceName() + " " + order.className().orElse("");
  }

  /** Orders are carried out one after the other: a flood of one kind would delay all others. */
  private Optional<String> tooSoon(ServiceOrder order) {
    long done = doneMicros.getOrDefault(kindOf(order), NEVER);
    double sinceS = Clock.seconds(clock().micros() - done);
    return sinceS < BETWEEN_S
        ? Optional.of(
            String.format(
                Locale.ROOT, "the same was done %.1f s ago; expected %.0f s", sinceS, BETWEEN_S))
        : Optional.empty();
  }

  private void answer(ServiceOrder order, Optional<String> refusal) {
    String what = order.action() + " " + order.serviceName();
    refusal.ifPresentOrElse(
        reason -> log(LogLevelEnum.ERROR, what + " not carried out: " + reason),
        () -> log(what + " done"));
    ServiceOrderResult result =
        new ServiceOrderResult()
            .requestId(order.requestId())
            .serviceName(order.serviceName())
            .accepted(refusal.isEmpty())
            .reason(refusal.orElse(""));
    answered.remember(order.requestId(), order, result);
    remember(); // for a launcher whose process is restarted
    publish(Channels.SERVICE_ORDERS, result);
  }

  @Override
  protected void handOver(HandOver state) {
    answered.handOver(state, ANSWERED);
  }

  @Override
  protected void takeOver(HandOver state) {
    answered.takeOver(state, ANSWERED, ServiceOrderResult.class);
  }
}
