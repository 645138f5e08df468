package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/** Orders to start and restart services of one process. */
@Timeout(120)
class LauncherTest {
  private static final VariableDeclaration<Double> GAIN =
      VariableDeclaration.number("GAIN", "").ifAbsent(0.5);

  @TempDir private Path directory;
  private final LockstepClock clock = new LockstepClock();
  private RunningSystem system;
  private Operator operator;
  private boolean isHeapFull;

  /** A service with a variable. */
  public static class Worker extends EventDrivenService {
    private final double gain;

    public Worker(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Worker");
      gain = getVariable(GAIN);
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** Another one, which may be told something that stands in no file. */
  public static final class Bystander extends EventDrivenService {
    private final String told;

    public Bystander(ServiceContext context) {
      this(context, "");
    }

    Bystander(ServiceContext context, String told) {
      super(context, ServiceRole.OBSERVER, "Bystander");
      this.told = told;
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** Gives orders and notes the answers. */
  private static final class Operator extends EventDrivenService {
    private final List<ServiceOrderResult> results = new ArrayList<>();

    Operator(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Operator");
      registerPublisher(Channels.SERVICE_ORDERS);
      registerSubscriber(Channels.SERVICE_ORDERS);
    }

    @Override
    public void callback(U2SAData data) {
      if (data instanceof ServiceOrderResult result) {
        results.add(result);
      }
    }
  }

  @BeforeEach
  void start() throws IOException, InterruptedException {
    write("Manager.xml", "<variable name=\"BROKER\" type=\"string\" value=\"none\"/>");
    write("Worker.xml", "");
    Files.writeString(
        directory.resolve("system.xml"),
        "<system id=\"test\"><communication configuration=\"Manager.xml\"/>"
            + "<service class=\""
            + Worker.class.getName()
            + "\" configuration=\"Worker.xml\"/>"
            + "<service class=\""
            + Bystander.class.getName()
            + "\"/></system>");
    begin(false);
  }

  private void begin(boolean isRestart) throws InterruptedException {
    system =
        RunningSystem.start(
            SystemFile.read(directory.resolve("system.xml")),
            new LaunchOptions()
                .clock(clock)
                .restart(isRestart)
                .logDirectory(directory.resolve("logs"))
                .making(Bystander.class, this::bystander));
    operator = new Operator(system.contextFor(XmlConfiguration.inMemory("test", Map.of())));
    operator.start();
    clock.advance(0);
  }

  private Bystander bystander(ServiceContext context) {
    if (isHeapFull) {
      throw new OutOfMemoryError("Java heap space");
    }
    return new Bystander(context, "a secret");
  }

  private void write(String name, String variables) throws IOException {
    Files.writeString(directory.resolve(name), "<configuration>" + variables + "</configuration>");
  }

  @AfterEach
  void close() {
    operator.kill();
    system.close();
  }

  private ServiceOrderResult order(String service, ServiceAction action)
      throws InterruptedException {
    String id = action + " " + operator.results.size();
    operator.publish(
        Channels.SERVICE_ORDERS,
        new ServiceOrder().requestId(id).serviceName(service).action(action).operator("test"));
    clock.advance(0);
    assertThat(operator.results).isNotEmpty();
    ServiceOrderResult last = operator.results.get(operator.results.size() - 1);
    assertThat(last.requestId()).isEqualTo(id);
    assertThat(last.serviceName()).isEqualTo(service);
    return last;
  }

  @Test
  void restart_runningService_endsItAndStartsANewOneInItsPlace() throws Exception {
    U2SAService before = system.services().get(0);

    assertThat(order("Worker", ServiceAction.RESTART).accepted()).isTrue();

    List<U2SAService> after = system.services();
    assertThat(before.isAlive()).isFalse();
    assertThat(after).extracting(Thread::getName).containsExactly("Worker", "Bystander");
    assertThat(after.get(0)).isNotSameAs(before).matches(U2SAService::isRunning);
  }

  @Test
  void restart_repeatedWithinASecond_isRefusedSoThatOtherOrdersNeedNotWait() throws Exception {
    order("Worker", ServiceAction.RESTART);
    U2SAService restarted = system.services().get(0);

    ServiceOrderResult repeated = order("Worker", ServiceAction.RESTART);
    assertThat(repeated.accepted()).isFalse();
    assertThat(repeated.reason()).contains("the same was done 0.0 s ago; expected 1 s");
    assertThat(system.services().get(0)).isSameAs(restarted);
    assertThat(order("Bystander", ServiceAction.RESTART).accepted()).isTrue();

    clock.advance(1_000_000);
    assertThat(order("Worker", ServiceAction.RESTART).accepted()).isTrue();
  }

  /** As a broker may deliver it (QoS 1), the second time after another order. */
  @Test
  void restart_orderThatArrivesTwice_isDoneOnceAndAnsweredAgain() throws Exception {
    ServiceOrder order = restartOfWorker();
    deliver(order);
    U2SAService restarted = system.services().get(0);

    clock.advance(2_000_000);
    deliver(order);
    assertThat(system.services().get(0)).isSameAs(restarted);
    assertThat(operator.results).hasSize(2);
    assertThat(operator.results).extracting(ServiceOrderResult::accepted).containsOnly(true);

    deliver(restartOfWorker());
    assertThat(system.services().get(0)).as("given again").isNotSameAs(restarted);
  }

  @Test
  void restart_orderThatArrivesAgainAtARestartedLauncher_isNotDoneAgain() throws Exception {
    ServiceOrder order = restartOfWorker();
    deliver(order);
    operator.kill();
    system.close();
    begin(true);
    U2SAService present = system.services().get(0);

    deliver(order);

    assertThat(system.services().get(0)).isSameAs(present);
    assertThat(operator.results).extracting(ServiceOrderResult::accepted).containsExactly(true);
  }

  private ServiceOrder restartOfWorker() {
    ServiceOrder order =
        new ServiceOrder().requestId("1").serviceName("Worker").action(ServiceAction.RESTART);
    order.timestamp(clock.micros());
    return order;
  }

  private void deliver(ServiceOrder order) throws InterruptedException {
    operator.publish(Channels.SERVICE_ORDERS, order);
    clock.advance(0);
  }

  @Test
  void restart_fileChangedMeanwhile_newServiceHasTheNewValue() throws Exception {
    write("Worker.xml", "<variable name=\"GAIN\" type=\"double\" value=\"2.0\"/>");

    order("Worker", ServiceAction.RESTART);

    assertThat(((Worker) system.services().get(0)).gain).isEqualTo(2.0);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "name=\"GAIN\" type=\"double\" value=\"much\"",
        "name=\"GAIN\" type=\"double\" value=\"1.0\" unit=\"m\"",
        "name=\"GAIM\" type=\"double\" value=\"1.0\""
      })
  void restart_fileBrokenMeanwhile_answersWhyAndTheServiceRunsOn(String broken) throws Exception {
    U2SAService before = system.services().get(0);
    write("Worker.xml", "<variable " + broken + "/>");

    ServiceOrderResult result = order("Worker", ServiceAction.RESTART);

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("Worker.xml").contains("\"GAI");
    assertThat(system.services().get(0)).isSameAs(before).matches(U2SAService::isRunning);
    write("Worker.xml", "");
    assertThat(order("Worker", ServiceAction.RESTART).accepted()).isTrue();
  }

  @Test
  void restart_serviceWithAMakerOfItsOwn_isMadeByThatEachTime() throws Exception {
    assertThat(((Bystander) system.services().get(1)).told).isEqualTo("a secret");

    assertThat(order("Bystander", ServiceAction.RESTART).accepted()).isTrue();

    assertThat(((Bystander) system.services().get(1)).told).isEqualTo("a secret");
  }

  @Test
  void restart_noMemoryForTheNewOne_answersWhyAndTheLauncherGoesOn() throws Exception {
    isHeapFull = true;
    ServiceOrderResult result = order("Bystander", ServiceAction.RESTART);

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("OutOfMemoryError").contains("Java heap space");

    isHeapFull = false;
    assertThat(order("Bystander", ServiceAction.RESTART).accepted()).isTrue();
    assertThat(system.services().get(1)).matches(U2SAService::isRunning);
  }

  @Test
  void start_serviceThatWasStopped_runsAgain() throws Exception {
    operator.publish(Channels.STOP, new StopCommand().serviceName("Worker"));
    clock.advance(0);
    system.services().get(0).join();

    assertThat(order("Worker", ServiceAction.START).accepted()).isTrue();
    assertThat(system.services().get(0).isRunning()).isTrue();
  }

  @Test
  void start_serviceThatRuns_isRefused() throws Exception {
    ServiceOrderResult result = order("Bystander", ServiceAction.START);

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("Bystander").contains("is already running");
  }

  @Test
  void order_serviceOfAnotherHost_isNotAnswered() throws Exception {
    operator.publish(
        Channels.SERVICE_ORDERS,
        new ServiceOrder().requestId("1").serviceName("Elsewhere").action(ServiceAction.RESTART));
    clock.advance(0);

    assertThat(operator.results).isEmpty();
  }

  @Test
  void close_afterARestart_endsTheNewServiceToo() throws Exception {
    order("Worker", ServiceAction.RESTART);

    system.close();

    assertThat(system.services()).noneMatch(Thread::isAlive);
  }
}
