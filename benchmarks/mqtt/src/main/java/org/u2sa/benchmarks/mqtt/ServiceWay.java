package org.u2sa.benchmarks.mqtt;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Our MQTT from a service to the callback of another, on that one's own thread. */
final class ServiceWay implements Way {
  private final Channel<StateInformation> channel;
  private final String filling;
  private final Half half;

  ServiceWay(int port, Ways.Load load, Sink sink) throws Exception {
    channel = Contents.channel(load.quality());
    filling = Contents.filling(load.bytes());
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    half =
        new Half(
            ServiceContext.of(
                    Contents.SYSTEM,
                    XmlConfiguration.inMemory(
                        Contents.SYSTEM, Map.of("INBOX CAPACITY", 1_000_000)))
                .clock(new SystemClock())
                .transport(U2saWay.transport(port))
                .logDirectory(logs)
                .build(),
            channel,
            sink);
    half.start();
  }

  @Override
  public void send(long sentNanos) throws InterruptedException {
    half.say(Contents.state(filling, sentNanos));
  }

  @Override
  public void close() {
    half.kill();
  }

  private static final class Half extends EventDrivenService {
    private final Channel<StateInformation> channel;
    private final Sink sink; // null: it sends

    Half(ServiceContext context, Channel<StateInformation> channel, Sink sink) {
      super(context, ServiceRole.OBSERVER, sink == null ? "Source" : "Sink");
      this.channel = channel;
      this.sink = sink;
      if (sink == null) {
        registerPublisher(channel);
      } else {
        registerSubscriber(channel);
      }
    }

    void say(StateInformation state) {
      publish(channel, state);
    }

    @Override
    public void callback(U2SAData data) {
      sink.arrived(Contents.sentNanos((StateInformation) data));
    }
  }
}
