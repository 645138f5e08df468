package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;

/**
 * A service whose callback does not return, in real time: what is seen of it, and how it is given
 * up.
 */
@Timeout(60)
class HungServiceTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @TempDir private Path directory;
  private final LocalBus bus = new LocalBus("test");
  private final List<U2SAData> published = new CopyOnWriteArrayList<>();
  private final CountDownLatch hangs = new CountDownLatch(1);
  private final CountDownLatch goesOn = new CountDownLatch(1);

  @AfterEach
  void letGo() {
    goesOn.countDown();
  }

  private final class Hanging extends EventDrivenService {
    private volatile boolean neutral;
    private volatile Boolean publishedAfterwards;
    private final boolean heedsInterrupts;

    Hanging(ServiceContext context, boolean heedsInterrupts) {
      super(context, ServiceRole.STATE_ESTIMATOR, "Hanging");
      this.heedsInterrupts = heedsInterrupts;
      registerPublisher(Channels.STATE);
      registerSubscriber(Channels.SENSED_STATE);
    }

    @Override
    public void callback(U2SAData data) {
      hangs.countDown();
      while (goesOn.getCount() > 0) {
        try {
          goesOn.await();
        } catch (InterruptedException e) {
          if (heedsInterrupts) {
            currentThread().interrupt();
            return;
          }
        }
      }
      publishedAfterwards = publish(Channels.STATE, new StateInformation().sensorName("late"));
    }

    @Override
    protected void release() {
      neutral = true;
    }
  }

  private Hanging make(boolean heedsInterrupts) {
    ServiceContext context =
        ServiceContext.of(
                "test", XmlConfiguration.inMemory("test", Map.of("HEALTH INTERVAL", 0.02)))
            .transport(bus)
            .logDirectory(directory)
            .build();
    return new Hanging(context, heedsInterrupts);
  }

  private Hanging hanging(boolean heedsInterrupts) throws InterruptedException {
    bus.attach((channel, message) -> published.add(message));
    Hanging service = make(heedsInterrupts);
    service.start();
    StateInformation state = new StateInformation().sensorName("a");
    state.freeze();
    bus.deliver(Channels.SENSED_STATE, state);
    hangs.await();
    return service;
  }

  @Test
  void overdueHealth_callbackDoesNotReturn_saysThatTheThreadLivesAndHowLongItRuns()
      throws InterruptedException {
    Hanging service = hanging(false);

    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () -> {
              HealthReport report = service.overdueHealth().orElseThrow();
              assertThat(report.status()).isEqualTo(ServiceStatus.RUNNING);
              assertThat(report.threadAlive()).hasValue(true);
              assertThat(report.callbackRunning().orElseThrow()).isGreaterThan(0.1);
            });
    goesOn.countDown();
    await().atMost(PATIENCE).untilAsserted(() -> assertThat(service.overdueHealth()).isEmpty());
    service.kill();
  }

  @Test
  void abandon_threadThatHeedsNoInterrupt_isCutOffNeutralAndItsNameIsFree()
      throws InterruptedException {
    Hanging service = hanging(false);

    service.abandon();

    assertThat(service.neutral).isTrue();
    assertThat(service.isRunning()).isFalse();
    assertThat(service.isAlive()).isTrue();
    make(false).kill(); // connects under the same name
    goesOn.countDown();
    service.join();
    assertThat(service.publishedAfterwards).isFalse();
    assertThat(published).noneMatch(StateInformation.class::isInstance);
  }

  @Test
  void abandon_threadThatHeedsInterrupts_endsByItself() throws InterruptedException {
    Hanging service = hanging(true);

    service.abandon();
    service.join();

    assertThat(service.neutral).isTrue();
  }
}
