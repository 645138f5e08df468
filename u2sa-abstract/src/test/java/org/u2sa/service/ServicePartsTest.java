package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.log.LogFile;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.service.inbox.CallbackStopwatch;
import org.u2sa.service.inbox.ContractOrders;
import org.u2sa.service.inbox.ServiceInbox;

/** Dispatch and life cycle by themselves, without a service. */
class ServicePartsTest {
  @TempDir private Path logs;
  private final List<String> steps = new ArrayList<>();
  private final List<LogFile> open = new ArrayList<>();
  private boolean running = true;

  @AfterEach
  void closeLogs() {
    open.forEach(LogFile::close);
  }

  private ServiceReceiver.Recipient recipient(String name) {
    ServiceContext context =
        ServiceContext.of("system", XmlConfiguration.inMemory(name, Map.of()))
            .logDirectory(logs)
            .build();
    ServiceConfiguration configuration = new ServiceConfiguration(context, name);
    open.add(configuration.log());
    ServiceHealth health = new ServiceHealth(new CallbackStopwatch(context.clock()));
    ServiceLife.Host host =
        new ServiceLife.Host(
            () -> running,
            continues -> running = continues,
            () -> steps.add("start"),
            () -> steps.add("refuse swap"),
            () -> {
              steps.add("release");
              throw new IllegalStateException("the device is gone");
            },
            () -> steps.add("report"),
            () -> steps.add("disconnect"));
    ServiceLife life = new ServiceLife(new Thread(() -> {}), configuration, health, null, host);
    return new ServiceReceiver.Recipient(
        configuration,
        new Registrations(),
        new ServiceInbox(10, configuration.clock()),
        life,
        new ContractOrders(state -> {}));
  }

  @Test
  void receive_orderToStopAnother_isIgnored() {
    ServiceReceiver.Recipient service = recipient("One");
    new ServiceReceiver(service).receive(Channels.STOP, new StopCommand().serviceName("Other"));
    assertThat(running).isTrue();
    assertThat(service.inbox().depth()).isZero();
  }

  @Test
  void receive_orderToStop_isObeyedAtOnceAndNotQueued() {
    ServiceReceiver.Recipient service = recipient("One");
    new ServiceReceiver(service).receive(Channels.STOP, new StopCommand().serviceName("One"));
    assertThat(running).isFalse();
    assertThat(service.life().isAskedToStop()).isTrue();
    assertThat(service.inbox().depth()).isZero();
  }

  @Test
  void receive_channelOfTheSuccessorOnly_waitsForIt() {
    ServiceReceiver.Recipient present = recipient("One");
    ServiceReceiver.Recipient next = recipient("Two");
    next.registrations().subscribe(Channels.STATE);
    ServiceReceiver receiver = new ServiceReceiver(present);
    receiver.receive(Channels.STATE, new StateInformation());
    receiver.prepare(next);
    receiver.receive(Channels.STATE, new StateInformation());
    assertThat(present.inbox().depth()).isZero();
    assertThat(next.inbox().depth()).isOne();
    receiver.forget();
    receiver.receive(Channels.STATE, new StateInformation());
    assertThat(next.inbox().replaced()).isZero();
  }

  @Test
  void end_releaseThatThrows_stillReportsAndDisconnectsOnce() {
    ServiceLife life = recipient("One").life();
    life.end();
    life.end();
    assertThat(steps).containsExactly("refuse swap", "release", "report", "disconnect");
    assertThat(life.status()).isEqualTo(ServiceStatus.STOPPED);
  }
}
