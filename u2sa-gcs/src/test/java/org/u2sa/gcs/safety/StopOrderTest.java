package org.u2sa.gcs.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

@Timeout(30)
class StopOrderTest {
  private final Broker broker = new Broker();
  private final RemoteLink link =
      new RemoteLink(broker, "test", new SystemClock(), 1.5, what -> {});
  private final Clock.Waiter waiter = link.clock().newWaiter("test");
  private final StopOrder order = new StopOrder(link, waiter, "operator", "smoke");

  /** Answers each subscription at once, as a broker with retained messages does. */
  private static final class Broker implements Transport, Connection {
    private final List<String> events = new ArrayList<>();
    private final List<String> stopIds = new ArrayList<>();
    private Receiver receiver;
    private Consumer<Channel<?>> onSubscription = channel -> {};
    private boolean takesNothing;

    @Override
    public Connection connect(String serviceName, Receiver to) {
      receiver = to;
      return this;
    }

    @Override
    public String systemId() {
      return Topic.ANY_SYSTEM;
    }

    @Override
    public String instance() {
      return "test";
    }

    @Override
    public boolean publish(Channel<?> channel, U2SAData message) {
      EmergencyStop stop = (EmergencyStop) message;
      stopIds.add(stop.identity());
      events.add("stop " + stop.systemId() + ": " + stop.reason());
      return !takesNothing;
    }

    @Override
    public boolean subscribe(Channel<?> channel) {
      events.add(channel.name());
      onSubscription.accept(channel);
      return true;
    }

    @Override
    public boolean unsubscribe(Channel<?> channel) {
      return true;
    }

    @Override
    public long refused() {
      return 0;
    }

    @Override
    public long missed() {
      return 0;
    }

    @Override
    public void close() {}

    private <T extends U2SAData> void deliver(Channel<T> channel, T message, String systemId) {
      message.systemId(systemId);
      message.freeze();
      receiver.receive(channel, message);
    }

    private void deliverHealth(String systemId, List<String> stops) {
      HealthReport report = new HealthReport().serviceName("Motor").status(ServiceStatus.RUNNING);
      deliver(Channels.HEALTH, report.emergencyStops(stops), systemId);
    }
  }

  @AfterEach
  void close() {
    waiter.close();
    link.close();
  }

  @Test
  void sendToAllHeard_retainedArmingState_stopsBeforeAnyHealthIsAskedFor() throws Exception {
    broker.onSubscription =
        channel -> {
          if (channel == Channels.ARMING_STATE) {
            broker.deliver(Channels.ARMING_STATE, new ArmingState(), "cessna");
          }
        };

    order.sendToAllHeard();

    assertThat(broker.events).containsExactly("arming-state", "stop cessna: smoke", "health");
  }

  @Test
  void await_severalSystems_eachIsStoppedOnceAndConfirmsForItself() throws Exception {
    broker.onSubscription =
        channel -> {
          if (channel == Channels.HEALTH) {
            broker.deliverHealth("cessna", broker.stopIds);
            broker.deliverHealth("boat", List.of());
          }
        };

    order.sendToAllHeard();
    SortedMap<String, StopConfirmation> vehicles = order.await();

    assertThat(broker.events.stream().filter(event -> event.startsWith("stop")))
        .containsExactly("stop cessna: smoke", "stop boat: smoke");
    assertThat(vehicles).containsOnlyKeys("boat", "cessna");
    assertThat(vehicles.get("cessna").missing(order.holds())).isEmpty();
    assertThat(vehicles.get("boat").missing(order.holds()))
        .singleElement(STRING)
        .startsWith("Motor is not stopped");
  }

  @Test
  void send_notTaken_isTold() {
    broker.takesNothing = true;

    order.send("cessna");

    assertThat(order.failure("cessna")).contains("did not accept");
    assertThat(order.failure("boat")).isEmpty();
  }

  @Test
  void send_inventedSystems_areBounded() {
    IntStream.range(0, 1_000).forEach(n -> order.send("system" + n));

    assertThat(broker.events).hasSize(64);
    assertThat(order.leftSome()).isTrue();
  }
}
