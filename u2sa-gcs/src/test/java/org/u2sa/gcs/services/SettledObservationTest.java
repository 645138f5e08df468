package org.u2sa.gcs.services;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceRole;

/** A system whose subscriber comes only after its publisher has answered. */
@Timeout(120)
class SettledObservationTest {
  private final LocalBus bus = new LocalBus("boat");
  private final Scripted scripted = new Scripted();

  /** Answers for its services: for the late one from the second question on. */
  private final class Scripted implements Receiver {
    private final Connection connection = bus.connect("Scripted", this);
    private final AtomicInteger asked = new AtomicInteger();
    private int lateComesAt = 2;

    private void start() {
      connection.subscribe(Channels.DISCOVERY);
      connection.subscribe(Channels.FUNCTIONALITY);
    }

    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      if (message instanceof DiscoveryRequest) {
        asked.incrementAndGet();
        discovery("Sensor", 60.0);
        if (asked.get() >= lateComesAt) {
          discovery("Late", asked.get() - lateComesAt < 1 ? 0.1 : 60.0);
        }
      } else if (message instanceof FunctionalityRequest) {
        offers("Sensor", List.of("power/BatteryState"), List.of());
        if (asked.get() >= lateComesAt) {
          offers("Late", List.of(), List.of("power/BatteryState"));
        }
      }
    }

    private void discovery(String name, double uptimeS) {
      publish(
          Channels.DISCOVERY,
          new DiscoveryResponse()
              .serviceName(name)
              .serviceType(ServiceRole.OBSERVER.name())
              .status(ServiceStatus.RUNNING)
              .uptime(uptimeS));
    }

    private void offers(String name, List<String> publishes, List<String> subscribes) {
      publish(
          Channels.FUNCTIONALITY,
          new FunctionalityResponse()
              .serviceName(name)
              .publishes(publishes)
              .subscribes(subscribes));
    }

    private void publish(Channel<?> channel, U2SAData message) {
      message.systemId("boat");
      message.freeze();
      connection.publish(channel, message);
    }

    @Override
    public void trouble(String what) {
      throw new AssertionError(what);
    }
  }

  private SettledObservation made(double timeoutS) throws InterruptedException {
    scripted.start();
    return SettledObservation.made(
        new RemoteLink(bus, "graph", new SystemClock(), timeoutS, line -> {}));
  }

  @Test
  void made_subscriberComesAfterTheFirstAnswer_isAwaited() throws InterruptedException {
    SettledObservation made = made(60.0);

    ServiceGraph graph = ServiceGraph.of(made.observation().directory().services());
    assertThat(made.hasSettled()).isTrue();
    assertThat(graph.unheard()).isEmpty();
    assertThat(graph.feeds())
        .containsExactly(new ServiceGraph.Feed("Sensor", "Late", "power", "BatteryState"));
  }

  @Test
  void made_noTimeForASecondAnswer_saysThatItHasNotSettled() throws InterruptedException {
    assertThat(made(0.1).hasSettled()).isFalse();
  }
}
