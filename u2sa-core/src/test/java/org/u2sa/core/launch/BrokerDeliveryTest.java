package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.testkit.FreePort;

/** Which way the messages of one process take: past the broker or through it. */
@Timeout(120)
class BrokerDeliveryTest {
  @TempDir private Path directory;
  private final int port = FreePort.find();

  /** Publishes states when the test says so. */
  public static final class Speaker extends EventDrivenService {
    public Speaker(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Speaker");
      registerPublisher(Channels.STATE);
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** Keeps the states that come in. */
  public static final class Listener extends EventDrivenService {
    private final List<U2SAData> heard = new CopyOnWriteArrayList<>();

    public Listener(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Listener");
      registerSubscriber(Channels.STATE);
    }

    @Override
    public void callback(U2SAData data) {
      heard.add(data);
    }
  }

  private SystemFile system(String communication) throws IOException {
    return SystemFile.read(
        Files.writeString(
            directory.resolve("system.xml"),
            """
            <system id="test">
              <communication %s/>
              <service class="%s"/>
              <service class="%s"/>
            </system>
            """
                .formatted(communication, Speaker.class.getName(), Listener.class.getName())));
  }

  private LaunchOptions options() {
    return new LaunchOptions()
        .override("CommunicationManager", "COMMUNICATION MANAGER PORT", port)
        .logDirectory(directory.resolve("logs"));
  }

  /** Whether the listener is handed the very object that was published: no broker can do that. */
  private boolean handsOverTheObject(SystemFile file, LaunchOptions options) {
    try (RunningSystem system = RunningSystem.start(file, options)) {
      StateInformation state = new StateInformation().sensorName("test").x(1.0);
      system.services().get(0).publish(Channels.STATE, state);
      Listener listener = (Listener) system.services().get(1);
      await().atMost(Duration.ofSeconds(60)).until(() -> !listener.heard.isEmpty());
      assertThat(listener.heard).containsExactly(state);
      return listener.heard.get(0) == state;
    }
  }

  @Test
  void start_unlessSaidOtherwise_deliversDirectly() throws IOException {
    assertThat(handsOverTheObject(system(""), options())).isTrue();
    assertThat(handsOverTheObject(system("delivery=\"direct\""), options())).isTrue();
  }

  @Test
  void start_deliveryByBroker_sendsEachMessageThroughIt() throws IOException {
    assertThat(handsOverTheObject(system("delivery=\"broker\""), options())).isFalse();
  }

  @Test
  void start_throughBrokerByOption_outweighsTheFile() throws IOException {
    assertThat(handsOverTheObject(system("delivery=\"direct\""), options().throughBroker()))
        .isFalse();
  }

  @Test
  void read_unknownDelivery_saysWhereAndWhatWasExpected() {
    assertThatThrownBy(() -> system("delivery=\"pigeon\""))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("system.xml, line 2")
        .hasMessageContaining("delivery \"pigeon\": expected one of direct, broker");
  }

  @Test
  void start_deliveryByBrokerWithoutOne_isRefused() throws IOException {
    SystemFile file = system("delivery=\"broker\"");
    LaunchOptions options = options().override("CommunicationManager", "BROKER", "none");

    assertThatThrownBy(() -> RunningSystem.start(file, options))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("\"BROKER\" of CommunicationManager is none")
        .hasMessageContaining("expected embedded or external");
  }

  @Test
  void start_deliveryByBrokerInLockstep_isRefused() throws IOException {
    SystemFile file = system("delivery=\"broker\"");

    assertThatThrownBy(() -> RunningSystem.start(file, options().clock(new LockstepClock())))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("take real time; expected --realtime");
  }
}
