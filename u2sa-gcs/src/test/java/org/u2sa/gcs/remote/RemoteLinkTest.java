package org.u2sa.gcs.remote;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.schema.U2SAData;

/** Whose time an order carries. */
@Timeout(60)
class RemoteLinkTest {
  private static final double HOUR_S = 3_600.0;

  private final SystemClock own = new SystemClock();
  private final LocalBus bus = new LocalBus("boat");
  private final BlockingQueue<ArmCommand> orders = new LinkedBlockingQueue<>();
  private final List<String> told = new ArrayList<>();

  /** A Safety Manager with a clock of its own. */
  private void vehicle(LongSupplier micros) {
    Connection[] connection = new Connection[1];
    connection[0] =
        bus.connect(
            "SafetyManager",
            new Receiver() {
              @Override
              public void receive(Channel<?> channel, U2SAData message) {
                if (message instanceof ArmCommand command) {
                  orders.add(command);
                } else if (message instanceof DiscoveryRequest) {
                  DiscoveryResponse answer =
                      new DiscoveryResponse()
                          .serviceName("SafetyManager")
                          .serviceType("SAFETY_MANAGER")
                          .status(ServiceStatus.RUNNING)
                          .uptime(1.0);
                  answer.systemId("boat");
                  answer.timestamp(micros.getAsLong());
                  answer.freeze();
                  connection[0].publish(Channels.DISCOVERY, answer);
                }
              }

              @Override
              public void trouble(String what) {
                throw new AssertionError(what);
              }
            });
    connection[0].subscribe(Channels.DISCOVERY);
    connection[0].subscribe(Channels.ARMING);
  }

  /** Time that an order carries, ahead of this computer's [s]. */
  private double aheadS() throws InterruptedException {
    try (RemoteLink link = new RemoteLink(bus, "arm", own, 3.0, told::add)) {
      link.adoptTime();
      link.publish(Channels.ARMING, new ArmCommand().requestId("1").arm(true).operator("Ann"));
    }
    ArmCommand order = orders.poll(30, TimeUnit.SECONDS);
    return Clock.seconds(order.timestamp().orElseThrow() - own.micros());
  }

  @Test
  void adoptTime_vehicleAnHourBehind_ordersCarryItsTime() throws InterruptedException {
    SystemClock behind = own.ahead(-Clock.micros(HOUR_S));
    vehicle(behind::micros);

    assertThat(aheadS()).isCloseTo(-HOUR_S, within(30.0));
    assertThat(told).singleElement().asString().contains("ahead of the clock of SafetyManager");
  }

  @Test
  void adoptTime_sameTime_saysNothing() throws InterruptedException {
    vehicle(own::micros);

    assertThat(aheadS()).isCloseTo(0.0, within(30.0));
    assertThat(told).isEmpty();
  }

  @Test
  void adoptTime_simulatedTime_ordersCarryThisComputersTime() throws InterruptedException {
    vehicle(() -> Clock.micros(100.0));

    assertThat(aheadS()).isCloseTo(0.0, within(30.0));
  }
}
