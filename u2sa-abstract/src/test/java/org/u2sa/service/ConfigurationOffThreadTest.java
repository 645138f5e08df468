package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.schema.U2SAData;

/** While others change its configuration, a control system goes on in time. */
@Timeout(120)
class ConfigurationOffThreadTest {
  @TempDir Path folder;
  private final LocalBus bus = new LocalBus("kit");
  private final List<ConfigurationTransactionResult> answers = new CopyOnWriteArrayList<>();
  private Path file;
  private Controlling service;

  /** Steps, and keeps what happened on which thread. */
  private static final class Controlling extends PeriodicService {
    private static final VariableDeclaration<Double> GAIN =
        VariableDeclaration.number("GAIN", "").ifAbsent(1.0);
    private static final VariableDeclaration<Double> LIMIT =
        VariableDeclaration.number("LIMIT", "").ifAbsent(1.0);
    private final AtomicLong steps = new AtomicLong();
    private final List<Thread> judges = new CopyOnWriteArrayList<>();
    private final List<Thread> told = new CopyOnWriteArrayList<>();
    private final List<String> seen =
        new CopyOnWriteArrayList<>(); // GAIN and LIMIT, as they change
    private volatile CountDownLatch gate; // holds judgement up, if there is one

    Controlling(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Controlling", 200.0);
      getVariable(GAIN);
      getVariable(LIMIT);
    }

    @Override
    protected void step(double nowS) {
      steps.incrementAndGet();
      String now = getVariable(GAIN) + "/" + getVariable(LIMIT);
      if (seen.isEmpty() || !seen.get(seen.size() - 1).equals(now)) {
        seen.add(now);
      }
    }

    @Override
    protected Optional<String> configurationRefusal(Map<String, Object> values) {
      judges.add(Thread.currentThread());
      CountDownLatch held = gate;
      while (held != null && held.getCount() > 0) {
        try {
          held.await();
        } catch (InterruptedException e) {
          return Optional.of("interrupted");
        }
      }
      return (Double) values.get("GAIN") < 0 ? Optional.of("GAIN is negative") : Optional.empty();
    }

    @Override
    protected void configurationChanged(Set<String> variableNames) {
      told.add(Thread.currentThread());
    }
  }

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("Controlling.xml");
    Files.writeString(
        file,
        "<configuration>\n"
            + "<variable name=\"GAIN\" type=\"double\" value=\"1.0\"/>\n"
            + "<variable name=\"LIMIT\" type=\"double\" value=\"1.0\"/>\n</configuration>\n");
    bus.attach(
        (Channel<?> channel, U2SAData message) -> {
          if (message instanceof ConfigurationTransactionResult result) {
            answers.add(result);
          }
        });
  }

  @AfterEach
  void kill() {
    if (service != null) {
      if (service.gate != null) {
        service.gate.countDown();
      }
      service.kill();
    }
  }

  private void start(Clock clock) {
    ServiceContext context =
        ServiceContext.of("kit", XmlConfiguration.load(file))
            .clock(clock)
            .transport(bus)
            .logDirectory(folder)
            .build();
    service = new Controlling(context);
    service.start();
  }

  private void send(int id, String gain) {
    List<ConfigurationAssignment> assignments = new ArrayList<>();
    assignments.add(new ConfigurationAssignment().variableName("GAIN").value(gain));
    assignments.add(new ConfigurationAssignment().variableName("LIMIT").value(gain));
    ConfigurationTransaction transaction =
        new ConfigurationTransaction()
            .requestId(String.valueOf(id))
            .serviceName("Controlling")
            .author("ann")
            .assignments(assignments);
    transaction.systemId("kit");
    transaction.timestamp(new SystemClock().micros());
    transaction.freeze();
    bus.deliver(Channels.CONFIGURATION, transaction);
  }

  private static void awaitThat(Callable<Boolean> condition) {
    await().atMost(Duration.ofSeconds(60)).until(condition);
  }

  private void awaitSteps(int more) {
    long from = service.steps.get();
    awaitThat(() -> service.steps.get() >= from + more);
  }

  @Test
  void change_whileItIsJudgedAndWritten_serviceStepsOn() {
    start(new SystemClock());
    service.gate = new CountDownLatch(1); // a disk that does not answer
    send(1, "2.0");
    awaitThat(() -> !service.judges.isEmpty());

    awaitSteps(20);

    assertThat(answers).isEmpty();
    assertThat(service.seen).containsExactly("1.0/1.0");
    service.gate.countDown();
    awaitThat(() -> !answers.isEmpty());
    awaitSteps(2);
    assertThat(answers.get(0).accepted()).isTrue();
    assertThat(service.seen).as("both variables at once").containsExactly("1.0/1.0", "2.0/2.0");
    assertThat(service.judges).doesNotContain(service);
    assertThat(service.told).containsExactly(service);
  }

  @Test
  void change_anotherProcessHoldsTheLock_answerSaysLockedAndServiceStepsMeanwhile()
      throws IOException {
    start(new SystemClock());
    awaitSteps(1);
    try (FileChannel other =
            FileChannel.open(
                folder.resolve(".configuration.lock"),
                StandardOpenOption.CREATE,
                StandardOpenOption.WRITE);
        FileLock lock = other.lock()) {
      assertThat(lock.isValid()).isTrue();
      long before = service.steps.get();
      send(1, "2.0");
      awaitThat(() -> !answers.isEmpty());

      assertThat(answers.get(0).accepted()).isFalse();
      assertThat(answers.get(0).reason()).contains(".configuration.lock is locked");
      assertThat(service.steps.get() - before).as("steps of 400 in 2 s").isGreaterThan(5);
    }
  }

  @Test
  void change_thousandsRefused_fewAreLookedAtAllAreAnsweredAndServiceStepsOn() {
    start(new SystemClock());
    service.gate = new CountDownLatch(1);
    for (int i = 0; i < 3_000; i++) {
      send(i, "-1.0");
      if (i % 500 == 0) {
        awaitSteps(2); // the inbox holds a thousand
      }
    }
    awaitSteps(20);
    service.gate.countDown();

    awaitThat(() -> isAnswered(-1) && hasReason("GAIN is negative"));
    awaitSteps(20);
    assertThat(service.judges).hasSizeLessThan(200);
    assertThat(service.judges).doesNotContain(service);
    assertThat(answers).noneMatch(ConfigurationTransactionResult::accepted);
    assertThat(hasReason("too many changes at once")).isTrue();
    assertThat(service.isRunning()).isTrue();
  }

  /** Asked again each time: an inbox that was full at first has left the request out. */
  private boolean isAnswered(int id) {
    send(id, "-1.0");
    return answers.stream().anyMatch(answer -> answer.requestId().equals(String.valueOf(id)));
  }

  private boolean hasReason(String reason) {
    return answers.stream().anyMatch(answer -> answer.reason().contains(reason));
  }

  /** However long the disk takes, simulated time stands still meanwhile. */
  @Test
  void change_inLockstep_isInForceAtTheTimeItWasAskedFor() throws InterruptedException {
    LockstepClock clock = new LockstepClock();
    start(clock);
    clock.advance(1_000_000);
    for (int i = 0; i < 10; i++) {
      send(i, String.valueOf(2.0 + i));
    }
    clock.advance(0);

    assertThat(answers).hasSize(10).allMatch(ConfigurationTransactionResult::accepted);
    assertThat(answers).allMatch(answer -> answer.timestamp().getAsLong() == 1_000_000);
    assertThat(service.getVariable("GAIN")).isEqualTo(11.0);
    assertThat(service.judges).doesNotContain(service);
  }

  @Test
  void change_whileTheServiceEnds_isNotBegunAnyMore() {
    start(new SystemClock());
    service.gate = new CountDownLatch(1);
    send(1, "2.0");
    awaitThat(() -> !service.judges.isEmpty());
    send(2, "3.0");
    awaitSteps(2);

    service.kill();
    service.gate.countDown();

    awaitThat(() -> !service.judges.get(0).isAlive());
    assertThat(service.judges).hasSize(1);
  }
}
