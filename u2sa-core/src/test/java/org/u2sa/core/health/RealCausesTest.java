package org.u2sa.core.health;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/**
 * Each way in which a service can fail, brought about in earnest and in real time, in one process.
 */
@Timeout(60)
class RealCausesTest {
  @TempDir private Path directory;
  private final List<ServiceCondition> conditions = new CopyOnWriteArrayList<>();
  private List<RunningSystem> systems = List.of();
  private Observer observer;

  /** Obeys goal commands that tell it how to fail; publishes a state at each step until then. */
  public static final class Victim extends PeriodicService {
    private final CountDownLatch never = new CountDownLatch(1);
    private boolean stalled;

    public Victim(ServiceContext context) {
      super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "Victim", 20.0);
      registerPublisher(Channels.SENSED_STATE);
      registerSubscriber(Channels.GOAL_COMMANDS);
    }

    @Override
    protected void step(double nowS) {
      if (!stalled) {
        publish(new StateInformation().sensorName("victim"));
      }
    }

    @Override
    public void callback(U2SAData data) {
      switch (((GoalCommand) data).uid()) {
        case "hang" -> hang();
        case "die" -> throw new AssertionError("told to die");
        case "fail" -> throw new IllegalStateException("told to fail");
        case "stall" -> stalled = true;
        default -> unexpected(data);
      }
    }

    private void hang() {
      while (true) {
        try {
          never.await();
        } catch (InterruptedException e) {
          log("heeds no interrupt");
        }
      }
    }
  }

  /** Its loop returns when it is told so, although it is running. */
  public static final class Careless extends U2SAService {
    private volatile boolean told;

    public Careless(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Careless");
      registerSubscriber(Channels.GOAL_COMMANDS);
    }

    @Override
    public void run() {
      try {
        while (isRunning() && !told) {
          sleep(50);
        }
      } catch (InterruptedException e) {
        currentThread().interrupt();
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

  /** Notes conditions. */
  private static final class Observer extends EventDrivenService {
    private final List<ServiceCondition> into;

    Observer(ServiceContext context, List<ServiceCondition> into) {
      super(context, ServiceRole.OBSERVER, "Observer");
      this.into = into;
      registerSubscriber(Channels.CONDITIONS);
    }

    @Override
    public void callback(U2SAData data) {
      into.add((ServiceCondition) data);
    }
  }

  private void start(Class<?> victim) throws IOException {
    String name = victim.getSimpleName();
    SystemFile file =
        SystemFile.read(
            Files.writeString(
                directory.resolve("system.xml"),
                "<system id=\"test\"><communication/><service class=\""
                    + victim.getName()
                    + "\"/><service class=\""
                    + HealthMonitor.class.getName()
                    + "\"/></system>"));
    systems = start(file, () -> options(name));
    observer =
        new Observer(
            systems.get(0).contextFor(XmlConfiguration.inMemory("test", Map.of())), conditions);
    observer.start();
    awaitCondition(Condition.ALIVE, 1);
  }

  private LaunchOptions options(String name) {
    return new LaunchOptions()
        .logDirectory(directory.resolve("logs"))
        .override(name, "MAX ERRORS IN A ROW", 1)
        .override("HealthMonitor", "WATCHED", name)
        .override("HealthMonitor", "HUNG AFTER", 1.0)
        .override("HealthMonitor", "RESTART DELAY", 0.0)
        .override("HealthMonitor", name + " DATA TIMEOUT", name.equals("Victim") ? 1.0 : 0.0);
  }

  /** Starts the two services of a system file: all in one, or in parts that are to be closed. */
  List<RunningSystem> start(SystemFile file, Supplier<LaunchOptions> options) throws IOException {
    return List.of(
        RunningSystem.start(
            file, options.get().override("CommunicationManager", "BROKER", "none")));
  }

  private U2SAService service(int place) {
    return systems.stream()
        .flatMap(system -> system.services().stream())
        .skip(place)
        .findFirst()
        .orElseThrow();
  }

  @AfterEach
  void close() {
    observer.kill();
    for (int i = systems.size() - 1; i >= 0; i--) {
      systems.get(i).close();
    }
  }

  private void tell(String what) {
    GoalCommand command = new GoalCommand().uid(what);
    observer.publish(Channels.GOAL_COMMANDS, command);
  }

  private void awaitCondition(Condition condition, long times) {
    await()
        .atMost(Duration.ofSeconds(20))
        .untilAsserted(
            () ->
                assertThat(conditions.stream().filter(each -> each.condition() == condition))
                    .hasSizeGreaterThanOrEqualTo((int) times));
  }

  /** The cause is recognised as what it is, and a new service takes the broken one's place. */
  private void expect(Condition condition, U2SAService before) {
    awaitCondition(condition, 1);
    awaitCondition(Condition.ALIVE, 2);
    assertThat(conditions)
        .extracting(ServiceCondition::condition)
        .isSubsetOf(Condition.ALIVE, Condition.SILENT, condition);
    assertThat(service(0)).isNotSameAs(before).matches(U2SAService::isRunning);
  }

  @Test
  void callbackThatNeverReturns_isHungAndReplaced() throws IOException {
    start(Victim.class);
    U2SAService before = service(0);
    tell("hang");
    expect(Condition.HUNG, before);
    assertThat(before.isRunning()).isFalse();
  }

  @Test
  void threadThatThrowsAnError_isDeadAndReplaced() throws IOException {
    start(Victim.class);
    U2SAService before = service(0);
    tell("die");
    expect(Condition.DEAD, before);
  }

  @Test
  void runThatReturns_isDeadAndReplaced() throws IOException {
    start(Careless.class);
    U2SAService before = service(0);
    tell("return");
    expect(Condition.DEAD, before);
  }

  @Test
  void tooManyErrors_isFailedAndReplaced() throws IOException {
    start(Victim.class);
    U2SAService before = service(0);
    tell("fail");
    expect(Condition.FAILED, before);
  }

  @Test
  void sensorWithoutData_isStalledAndReplaced() throws IOException {
    start(Victim.class);
    U2SAService before = service(0);
    tell("stall");
    expect(Condition.STALLED, before);
  }

  @Test
  void stopCommand_isStoppedAndNotReplaced() throws Exception {
    start(Victim.class);
    U2SAService before = service(0);
    observer.publish(Channels.STOP, new StopCommand().serviceName("Victim"));
    awaitCondition(Condition.STOPPED, 1);

    assertThat(service(0)).isSameAs(before);
    assertThat(conditions).extracting(ServiceCondition::restarts).containsOnly(0L);
  }

  @Test
  void monitorThatIsDead_isReplacedByItsProcess() throws IOException {
    start(Victim.class);
    U2SAService monitor = service(1);
    monitor.getUncaughtExceptionHandler().uncaughtException(monitor, new AssertionError("dies"));

    await()
        .untilAsserted(
            () -> assertThat(service(1)).isNotSameAs(monitor).matches(U2SAService::isRunning));
  }
}
