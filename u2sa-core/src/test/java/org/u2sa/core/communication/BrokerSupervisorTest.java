package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.testkit.FreePort;

/** What is done about an embedded broker that fails. */
@Timeout(120)
class BrokerSupervisorTest {
  private static final Duration SOON = Duration.ofSeconds(30);

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final List<Runnable> died = new CopyOnWriteArrayList<>();
  private final AtomicInteger failuresToCome = new AtomicInteger();
  private RuntimeException failure = new CommunicationException("the port is taken");
  private final InetSocketAddress address = new InetSocketAddress("127.0.0.1", FreePort.find());
  private BrokerSupervisor keeper;

  @BeforeEach
  void start() {
    keeper = new BrokerSupervisor(this::broker, log::add);
  }

  private EmbeddedBroker broker(Runnable whenDead) {
    if (failuresToCome.getAndUpdate(left -> Math.max(0, left - 1)) > 0) {
      throw failure;
    }
    died.add(whenDead);
    return EmbeddedBroker.start(
        new LocalBus("cessna"),
        new MessageCodec(StandardTypes.registry()),
        address,
        Optional.empty(),
        new BrokerSecurity(null, null),
        XmlConfiguration.inMemory("test", Map.of()).settings(BrokerLimits.class).get(),
        log::add,
        whenDead);
  }

  @AfterEach
  void stop() {
    keeper.close();
  }

  private void awaitBrokers(int started) {
    await().atMost(SOON).until(() -> died.size() == started && again() == started - 1);
  }

  private long again() {
    return log.stream().filter(line -> line.contains("restarted")).count();
  }

  private void connect() throws IOException {
    try (Socket socket = new Socket()) {
      socket.connect(address);
    }
  }

  @Test
  void died_toldBySeveralThreads_oneNewBrokerListens() throws IOException {
    died.get(0).run();
    died.get(0).run();

    awaitBrokers(2);
    connect();
    died.get(1).run(); // and the next one
    awaitBrokers(3);
    assertThat(again()).isEqualTo(2);
  }

  @Test
  void died_portTakenMeanwhile_triesUntilItIsFree() throws IOException {
    failuresToCome.set(2);

    died.get(0).run();

    awaitBrokers(2);
    assertThat(log.get(0)).contains("the port is taken").contains("retrying");
    assertThat(log).filteredOn(line -> line.contains("the port is taken")).hasSize(1);
    connect();
  }

  @Test
  void died_startFailsUnexpectedly_triesOnAllTheSame() throws IOException {
    failure = new IllegalStateException("a bug");
    failuresToCome.set(2);

    died.get(0).run();

    awaitBrokers(2);
    assertThat(log).filteredOn(line -> line.contains("a bug")).hasSize(1);
    connect();
  }

  @Test
  void close_whileNoneCanBeStarted_endsTheTrying() {
    failuresToCome.set(Integer.MAX_VALUE);
    died.get(0).run();
    await().atMost(SOON).until(() -> !log.isEmpty());

    keeper.close();

    await()
        .atMost(SOON)
        .until(
            () ->
                Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> thread.getName().equals("u2sa-broker-restart")));
    assertThat(keeper.dropped()).isZero();
  }

  @Test
  void isOfVehicle_whileAnotherThreadReplacesTheBroker_doesNotWaitForIt() throws Exception {
    synchronized (keeper) { // as a restart holds it while the network's thread drains
      CompletableFuture<Boolean> answer =
          CompletableFuture.supplyAsync(() -> keeper.isOfVehicle("PathPlanner"));

      assertThat(answer.get(30, TimeUnit.SECONDS)).isFalse();
    }
  }
}
