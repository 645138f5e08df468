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
import org.u2sa.core.launch.SwapCandidates.Broken;
import org.u2sa.core.launch.SwapCandidates.Choosy;
import org.u2sa.core.launch.SwapCandidates.First;
import org.u2sa.core.launch.SwapCandidates.Narrow;
import org.u2sa.core.launch.SwapCandidates.Planner;
import org.u2sa.core.launch.SwapCandidates.Second;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/** Orders to put another class in the place of a service, and why they may be refused. */
@Timeout(120)
class SwapOrderTest {
  @TempDir private Path directory;
  private final LockstepClock clock = new LockstepClock();
  private final List<ServiceOrderResult> results = new ArrayList<>();
  private RunningSystem system;
  private EventDrivenService operator;

  @BeforeEach
  void start() throws IOException, InterruptedException {
    write("Manager.xml", "<variable name=\"BROKER\" type=\"string\" value=\"none\"/>");
    write("Worker.xml", "<variable name=\"TRIM\" type=\"double\" value=\"2\"/>");
    String text =
        "<system id=\"test\"><communication configuration=\"Manager.xml\"/><service class=\""
            + First.class.getName()
            + "\" configuration=\"Worker.xml\"/></system>";
    system =
        RunningSystem.start(
            SystemFile.read(Files.writeString(directory.resolve("system.xml"), text)),
            new LaunchOptions()
                .clock(clock)
                .logDirectory(directory.resolve("logs"))
                .override("First", "GAIN", 0.75));
    operator =
        new EventDrivenService(
            system.contextFor(XmlConfiguration.inMemory("test", Map.of())),
            ServiceRole.OBSERVER,
            "Operator") {
          @Override
          public void callback(U2SAData data) {
            if (data instanceof ServiceOrderResult result) {
              results.add(result);
            }
          }
        };
    operator.registerSubscriber(Channels.SERVICE_ORDERS);
    operator.start();
    clock.advance(0);
  }

  private void write(String name, String variables) throws IOException {
    Files.writeString(directory.resolve(name), "<configuration>" + variables + "</configuration>");
  }

  @AfterEach
  void close() {
    operator.kill();
    system.close();
  }

  private ServiceOrderResult order(ServiceAction action, String className)
      throws InterruptedException {
    ServiceOrder order =
        new ServiceOrder().requestId("1").serviceName("Worker").action(action).operator("test");
    operator.publish(
        Channels.SERVICE_ORDERS, className == null ? order : order.className(className));
    clock.advance(0);
    assertThat(results).hasSize(1);
    return results.remove(0);
  }

  private ServiceOrderResult swap(Class<?> type) throws InterruptedException {
    return order(ServiceAction.SWAP, type.getName());
  }

  private U2SAService present() {
    assertThat(system.services()).hasSize(1);
    return system.services().get(0);
  }

  private void assertRefused(ServiceOrderResult result, String... words) {
    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains(words);
    assertThat(present()).isInstanceOf(First.class);
    assertThat(present().isRunning()).isTrue();
  }

  @Test
  void swap_serviceOfTheSameRole_runsInItsPlaceWithItsNameStateAndConfiguration()
      throws InterruptedException {
    U2SAService before = present();

    ServiceOrderResult result = swap(Second.class);

    assertThat(result.accepted()).as(result.reason()).isTrue();
    assertThat(present()).isInstanceOf(Second.class);
    assertThat(present().isRunning()).isTrue();
    assertThat(((Second) present()).from).hasValue("Worker");
    assertThat(present().getServiceName()).isEqualTo("Worker");
    assertThat(present().getVariable("GAIN")).isEqualTo(0.75); // the run's own override
    before.join();
  }

  @Test
  void swap_thereAndBack_servesTheFirstClassAgain() throws InterruptedException {
    swap(Second.class);

    assertThat(swap(First.class).accepted()).isTrue();

    assertThat(present()).isInstanceOf(First.class);
    assertThat(present().getVariable("TRIM")).isEqualTo(2.0);
  }

  @Test
  void restart_afterASwap_startsTheClassThatRanLast() throws InterruptedException {
    swap(Second.class);

    assertThat(order(ServiceAction.RESTART, null).accepted()).isTrue();

    assertThat(present()).isInstanceOf(Second.class);
    assertThat(present().isRunning()).isTrue();
    assertThat(present().getServiceName()).isEqualTo("Worker");
  }

  @Test
  void swap_noClassNamed_isRefused() throws InterruptedException {
    assertRefused(order(ServiceAction.SWAP, null), "className", "missing");
  }

  @Test
  void swap_unknownClass_isRefused() throws InterruptedException {
    assertRefused(
        order(ServiceAction.SWAP, "org.example.Nothing"), "org.example.Nothing", "class path");
  }

  @Test
  void swap_noService_isRefused() throws InterruptedException {
    assertRefused(swap(String.class), "is not a service");
  }

  @Test
  void swap_withoutAPublicConstructor_isRefused() throws InterruptedException {
    assertRefused(swap(EventDrivenService.class), "expected a public constructor");
  }

  @Test
  void swap_otherRole_isRefused() throws InterruptedException {
    assertRefused(swap(Planner.class), "PATH_PLANNER", "OBSERVER");
  }

  @Test
  void swap_constructorThrows_isRefused() throws InterruptedException {
    assertRefused(swap(Broken.class), "no such device");
  }

  @Test
  void swap_configurationIsWrongForIt_isRefused() throws InterruptedException {
    assertRefused(swap(Narrow.class), "GAIN", "0.75");
  }

  @Test
  void swap_takeOverThrows_isRefused() throws InterruptedException {
    assertRefused(swap(Choosy.class), "FROM is not enough");
  }
}
