package org.u2sa.core.launch;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.directory.ClockAgreement;

/**
 * Prevents a process from running a service that already runs in another process of the same
 * system: asks all services for their names before the first one is created here, and refuses to
 * connect a service whose name is in use. The answers' timestamps reveal clock offsets. Services
 * that hang, or are being started elsewhere at the same moment, do not answer; observers
 * distinguish duplicates by instance.
 */
final class DuplicateCheck implements Transport, Receiver {
  /** Time to wait for answers. */
  private static final double ANSWERS_WITHIN_S = 1.0;

  private static final long LOOK_MICROS = 10_000;

  private final Transport transport;
  private final Map<String, String> hosts = new ConcurrentHashMap<>(); // by service name

  private final Consumer<String> log;
  private final Clock clock;
  private final ClockAgreement agreement;

  private DuplicateCheck(Transport transport, Clock clock, Consumer<String> log) {
    this.transport = transport;
    this.clock = clock;
    this.log = log;
    agreement = new ClockAgreement(clock.micros());
  }

  /**
   * Asks, and returns a transport that only connects services with free names.
   *
   * @param clock real time
   * @param log receives problems, one per line
   */
  static DuplicateCheck before(Transport transport, Clock clock, Consumer<String> log) {
    DuplicateCheck call = new DuplicateCheck(transport, clock, log);
    call.ask(false);
    return call;
  }

  /**
   * Determines the clock offset without checking names, because a restarted service's name may
   * still be registered; the first answer suffices.
   */
  static DuplicateCheck forTime(Transport transport, Clock clock, Consumer<String> log) {
    DuplicateCheck call = new DuplicateCheck(transport, clock, log);
    call.ask(true);
    call.hosts.clear();
    return call;
  }

  private void ask(boolean oneWillDo) {
    DiscoveryRequest question = new DiscoveryRequest();
    question.systemId(transport.systemId());
    question.timestamp(clock.micros());
    question.freeze();
    try (Connection connection = transport.connect("DuplicateCheck", this);
        Clock.Waiter waiter = clock.newWaiter("roll-call")) {
      connection.subscribe(Channels.DISCOVERY);
      agreement.asked(clock.micros());
      connection.publish(Channels.DISCOVERY, question);
      long deadline = clock.micros() + Clock.micros(ANSWERS_WITHIN_S);
      while (clock.micros() < deadline && !(oneWillDo && !hosts.isEmpty())) {
        waiter.await(Math.min(deadline, clock.micros() + LOOK_MICROS));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CommunicationException("interrupted while asking for running services", e);
    }
  }

  /**
   * Lead of the system's time over the clock, from the answers [µs]; 0 if the clocks agree or no
   * answer arrived. Logs any other offset.
   */
  long systemAheadMicros() {
    return agreement.aheadMicros(log);
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    String host = hosts.get(serviceName);
    if (host != null) {
      throw new CommunicationException(
          String.format(
              "service name \"%s\" is taken in system \"%s\" by a service on host \"%s\":"
                  + " service names must be unique",
              serviceName, systemId(), host));
    }
    return transport.connect(serviceName, receiver);
  }

  @Override
  public String systemId() {
    return transport.systemId();
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof DiscoveryResponse response) {
      agreement.hear(response, clock.micros());
      hosts.put(response.serviceName(), response.host());
    }
  }

  @Override
  public void trouble(String what) {
    log.accept("looking for running services: " + what);
  }
}
