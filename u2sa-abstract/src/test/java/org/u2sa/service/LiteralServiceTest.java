package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.LongStream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** A service written word by word as thesis 8.2.4 says does all that a service must do. */
@Timeout(60)
class LiteralServiceTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** How the author of the loop waits. */
  private enum Wait {
    BY_SLEEP_OF_SERVICE,
    BY_SLEEP_OF_THREAD,
    NEVER
  }

  /** Publishes what it heard last, again and again. */
  private static final class Echo extends U2SAService {
    private final Wait wait;
    private final List<U2SAData> heard = new CopyOnWriteArrayList<>();
    private final CountDownLatch first = new CountDownLatch(1);
    private volatile double last;
    private volatile int passes;
    private volatile boolean deviceClosed;

    Echo(ServiceContext context, Wait wait) {
      super(context, ServiceRole.STATE_ESTIMATOR, "Echo");
      this.wait = wait;
      getVariable("GAIN");
      registerSubscriber("sensed-state");
      registerPublisher("state");
    }

    @Override
    public void run() {
      while (running) {
        publish("state", new StateInformation().sensorName("Echo").x(last));
        passes++;
        try {
          if (wait == Wait.BY_SLEEP_OF_SERVICE) {
            sleep(100);
          } else if (wait == Wait.BY_SLEEP_OF_THREAD) {
            Thread.sleep(5);
          } else {
            Thread.yield();
          }
        } catch (InterruptedException e) {
          log("interrupted");
        }
      }
    }

    @Override
    public void callback(U2SAData data) {
      heard.add(data);
      first.countDown();
      if (data instanceof StateInformation state) {
        last = state.x().orElse(0.0);
      } else {
        log("not expected: " + data);
      }
    }

    @Override
    public void kill() {
      deviceClosed = true;
      running = false;
    }
  }

  private Echo started(Wait wait) {
    return kit.with("GAIN", 1.0).start(context -> new Echo(context, wait));
  }

  private static StateInformation sensed(double x) {
    return new StateInformation().sensorName("Sensor").x(x);
  }

  private void assertEnded(Echo echo) {
    assertThat(echo.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(echo.isAlive()).isFalse();
    assertThat(echo.deviceClosed).isTrue();
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().status()).isEqualTo(ServiceStatus.STOPPED);
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void callback_messages_arrivesBesideTheLoop(Wait wait) {
    Echo echo = started(wait);

    kit.publish(Channels.SENSED_STATE, sensed(1.0));
    kit.publish(Channels.SENSED_STATE, sensed(2.0));

    assertThat(echo.heard).hasSize(2);
    assertThat(echo.last).isEqualTo(2.0);
  }

  @Test
  void run_neverWaits_messagesAreHandledAllTheSame() {
    Echo echo = started(Wait.NEVER);

    kit.publish(Channels.SENSED_STATE, sensed(1.0));

    assertThat(echo.heard).hasSize(1);
    assertThat(kit.log("Echo")).anyMatch(line -> line.contains("sleep(…)"));
  }

  @Test
  void sleep_inLockstep_onePassEveryTenthOfASecond() {
    Echo echo = started(Wait.BY_SLEEP_OF_SERVICE);
    kit.forget();

    kit.advance(1.0);

    assertThat(echo.passes).isEqualTo(11);
    assertThat(kit.published(Channels.STATE))
        .extracting(state -> state.timestamp().orElseThrow())
        .containsExactlyElementsOf(
            LongStream.rangeClosed(1, 10).mapToObj(tenth -> tenth * 100_000L).toList());
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void discovery_request_isAnsweredAndHealthIsReported(Wait wait) {
    started(wait);

    kit.publish(Channels.DISCOVERY, new DiscoveryRequest());
    kit.publish(Channels.FUNCTIONALITY, new FunctionalityRequest().serviceName("Echo"));
    kit.advance(1.0);

    assertThat(kit.published(Channels.DISCOVERY))
        .filteredOn(DiscoveryResponse.class::isInstance)
        .singleElement()
        .satisfies(
            answer ->
                assertThat(((DiscoveryResponse) answer).status()).isEqualTo(ServiceStatus.RUNNING));
    assertThat(kit.published(Channels.FUNCTIONALITY))
        .filteredOn(FunctionalityResponse.class::isInstance)
        .hasSize(1);
    assertThat(kit.published(Channels.HEALTH))
        .hasSizeBetween(4, 5)
        .allSatisfy(
            report -> {
              assertThat(report.status()).isEqualTo(ServiceStatus.RUNNING);
              assertThat(report.threadAlive().orElse(true)).isTrue();
            });
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void stopCommand_running_endsCleanly(Wait wait) {
    Echo echo = started(wait);

    kit.publish(Channels.STOP, new StopCommand().serviceName("Echo"));

    assertEnded(echo);
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void kill_nothingElseCalled_endsCleanly(Wait wait) {
    Echo echo = started(wait);

    echo.kill();
    kit.advance(0.3);

    assertEnded(echo);
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void shutDown_running_returnsWhenItHasEnded(Wait wait) {
    Echo echo = started(wait);

    echo.shutDown();

    assertEnded(echo);
  }

  @Test
  void shutDown_neverStarted_closesConnectionAndLog() {
    Echo echo = new Echo(kit.with("GAIN", 1.0).context(), Wait.NEVER);

    echo.shutDown();

    assertThat(echo.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(echo.deviceClosed).isTrue();
    started(Wait.BY_SLEEP_OF_SERVICE); // the name is free
  }

  @Test
  void configuration_change_isWrittenAndAnswered() {
    Echo echo = started(Wait.BY_SLEEP_OF_SERVICE);

    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange().serviceName("Echo").variableName("GAIN").value("2.5"));
    kit.advance(0.2);

    assertThat(kit.published(Channels.CONFIGURATION))
        .filteredOn(ConfigurationChangeResult.class::isInstance)
        .hasSize(1);
    assertThat(echo.getVariable("GAIN")).isEqualTo(2.5);
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void swap_literalForLiteral_theFirstEndsAndTheSecondGoesOn(Wait wait) {
    Echo before = started(wait);

    Echo after = kit.swap(before, context -> new Echo(context, wait));
    kit.publish(Channels.SENSED_STATE, sensed(3.0));
    kit.advance(0.1);

    assertThat(before.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(before.isAlive()).isFalse();
    assertThat(before.deviceClosed).isTrue();
    assertThat(before.heard).isEmpty();
    assertThat(after.heard).hasSize(1);
    assertThat(after.isRunning()).isTrue();
  }

  @Test
  void restart_running_startsAnother() {
    Echo before = started(Wait.BY_SLEEP_OF_SERVICE);

    Echo after = kit.restart(before, context -> new Echo(context, Wait.BY_SLEEP_OF_SERVICE));

    assertThat(before.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(after.isRunning()).isTrue();
  }

  /** Only handles messages: its run() has nothing to do. */
  private static final class Listener extends U2SAService {
    private final List<U2SAData> heard = new CopyOnWriteArrayList<>();

    Listener(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Listener");
      registerSubscriber("state");
    }

    @Override
    public void run() {}

    @Override
    public void callback(U2SAData data) {
      heard.add(data);
    }

    @Override
    public void kill() {
      running = false;
    }
  }

  @Test
  void run_empty_messagesAreHandledUntilTheServiceIsKilled() {
    Listener listener = kit.start(Listener::new);
    kit.advance(1.0);

    kit.publish(Channels.STATE, sensed(1.0));
    assertThat(listener.heard).hasSize(1);
    assertThat(listener.status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(listener.overdueHealth()).isEmpty();

    listener.kill();
    kit.advance(0.3);
    assertThat(listener.status()).isEqualTo(ServiceStatus.STOPPED);
  }

  /** Its loop fails when it is told to. */
  private static final class Failing extends U2SAService {
    private volatile boolean told;

    Failing(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Failing");
      registerSubscriber("state");
    }

    @Override
    public void run() {
      while (running) {
        if (told) {
          throw new IllegalStateException("device lost");
        }
        try {
          sleep(100);
        } catch (InterruptedException e) {
          log("interrupted");
        }
      }
    }

    @Override
    public void callback(U2SAData data) {
      told = true;
    }

    @Override
    public void kill() {
      running = false;
    }
  }

  @Test
  void run_throws_serviceFailsAndTimeGoesOn() {
    Failing failing = kit.start(Failing::new);

    kit.publish(Channels.STATE, sensed(1.0));
    kit.advance(1.0);

    assertThat(failing.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().lastError())
        .hasValueSatisfying(error -> assertThat(error).contains("device lost"));
    assertThat(kit.nowS()).isEqualTo(1.0);
  }

  @ParameterizedTest
  @EnumSource(names = {"BY_SLEEP_OF_SERVICE", "BY_SLEEP_OF_THREAD"})
  void realTime_messageAndKill_isHandledAndEnds(Wait wait, @TempDir Path logs) throws Exception {
    LocalBus bus = new LocalBus("real");
    Echo echo =
        new Echo(
            ServiceContext.of("real", XmlConfiguration.inMemory("the test", Map.of("GAIN", 1.0)))
                .transport(bus)
                .logDirectory(logs)
                .build(),
            wait);
    echo.start();
    StateInformation sensed = sensed(1.0);
    sensed.systemId("real");
    sensed.timestamp(1L);
    sensed.freeze();
    bus.deliver(Channels.SENSED_STATE, sensed);
    assertThat(echo.first.await(30, TimeUnit.SECONDS)).isTrue();

    echo.kill();
    echo.awaitEnd();

    assertThat(echo.status()).isEqualTo(ServiceStatus.STOPPED);
  }
}
