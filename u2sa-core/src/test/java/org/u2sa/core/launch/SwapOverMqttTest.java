package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.ServiceSwap;
import org.u2sa.testkit.FreePort;

/** Many swaps of a service that is reached over MQTT: no message is lost, none handled twice. */
@Timeout(120)
class SwapOverMqttTest {
  private static final int SWAPS = 30;
  private static final int MESSAGES_EACH = 100;
  private static final int MESSAGES = SWAPS * MESSAGES_EACH;

  @TempDir private Path logs;
  private final CountDownLatch last = new CountDownLatch(1);
  private final Semaphore toPublish = new Semaphore(0);

  /** Keeps numbers only, as many as come. */
  private final class Numbers extends EventDrivenService {
    private final List<Integer> handled = new ArrayList<>(); // of this instance, in order
    private final CountDownLatch first = new CountDownLatch(1);

    Numbers(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Numbers");
      registerSubscriber(Channels.GOAL_COMMANDS);
    }

    @Override
    public void callback(U2SAData data) {
      int number = Integer.parseInt(((GoalCommand) data).uid());
      handled.add(number);
      first.countDown();
      if (number == MESSAGES - 1) {
        last.countDown();
      }
    }
  }

  /** Publishes and hears nothing. */
  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {}

    @Override
    public void trouble(String what) {
      throw new AssertionError(what);
    }
  }

  private ServiceContext.Builder context(MqttTransport transport, XmlConfiguration configuration) {
    return ServiceContext.of("stress", configuration)
        .clock(new SystemClock())
        .transport(transport)
        .logDirectory(logs);
  }

  @Test
  void swap_overMqtt_eachMessageIsHandledOnce() throws Exception {
    int port = FreePort.find();
    XmlConfiguration manager =
        XmlConfiguration.inMemory(
            "test",
            Map.of("COMMUNICATION MANAGER PORT", port, "CLIENT ORDERS PER SECOND", 100_000));
    MqttTransport transport =
        new MqttTransport("127.0.0.1", port, "stress", new MessageCodec(StandardTypes.registry()));
    try (CommunicationManager communication =
        CommunicationManager.start("stress", manager, StandardTypes.registry(), line -> {})) {
      assertThat(communication).isNotNull();
      XmlConfiguration configuration =
          XmlConfiguration.inMemory("Numbers", Map.of("INBOX CAPACITY", MESSAGES));
      List<Numbers> all = new ArrayList<>();
      all.add(new Numbers(context(transport, configuration).build()));
      all.get(0).start();
      CompletableFuture<Void> published = CompletableFuture.runAsync(() -> publish(transport));

      for (int i = 0; i < SWAPS; i++) {
        Numbers old = all.get(all.size() - 1);
        toPublish.release(MESSAGES_EACH);
        assertThat(old.first.await(30, TimeUnit.SECONDS)).as("a message for number %d", i).isTrue();
        Numbers next =
            new Numbers(context(transport, configuration.forSuccessor()).inPlaceOf(old).build());
        assertThat(new ServiceSwap(old, next, () -> true).order().await(10.0)).isEmpty();
        all.add(next);
      }
      published.get();
      assertThat(last.await(30, TimeUnit.SECONDS)).isTrue();
      all.get(all.size() - 1).kill();

      List<Integer> handled = new ArrayList<>();
      all.forEach(service -> handled.addAll(service.handled));
      assertThat(handled).hasSize(MESSAGES).doesNotHaveDuplicates().isSorted();
    }
  }

  private void publish(MqttTransport transport) {
    try (Connection publisher = transport.connect("publisher", new Deaf())) {
      for (int i = 0; i < MESSAGES; i++) {
        toPublish.acquireUninterruptibly();
        GoalCommand message = new GoalCommand().uid(Integer.toString(i));
        message.freeze();
        assertThat(publisher.publish(Channels.GOAL_COMMANDS, message)).isTrue();
      }
    }
  }
}
