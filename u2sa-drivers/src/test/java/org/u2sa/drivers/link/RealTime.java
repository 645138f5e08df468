package org.u2sa.drivers.link;

import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** One service in real time, for tests of real links; all else runs in the test kit's time. */
public final class RealTime implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String SYSTEM_ID = "real";

  private final SystemClock clock = new SystemClock();
  private final LocalBus bus = new LocalBus(SYSTEM_ID);
  private final Map<String, U2SAData> latest = new ConcurrentHashMap<>(); // by channel
  private final Map<String, Queue<U2SAData>> all = new ConcurrentHashMap<>(); // by channel
  private final Map<String, Object> variables = new HashMap<>();
  private final Path logs;
  private U2SAService service;

  /** Logs go to a folder. */
  public RealTime(Path logs) {
    this.logs = logs;
    bus.attach((channel, message) -> keep(channel.name(), message));
  }

  private void keep(String channel, U2SAData message) {
    latest.put(channel, message);
    all.computeIfAbsent(channel, name -> new ConcurrentLinkedQueue<>()).add(message);
  }

  /** Sets a variable of the service. */
  public RealTime with(String variable, Object value) {
    variables.put(variable, value);
    return this;
  }

  /** The run's clock. */
  public Clock clock() {
    return clock;
  }

  /** Starts the service. */
  public void start(Function<ServiceContext, U2SAService> constructor) {
    service =
        constructor.apply(
            ServiceContext.of(SYSTEM_ID, XmlConfiguration.inMemory("the test", variables))
                .clock(clock)
                .transport(bus)
                .logDirectory(logs)
                .build());
    service.start();
  }

  /** What was published last on a channel. */
  public <T extends U2SAData> Optional<T> latest(Channel<T> channel) {
    return Optional.ofNullable(latest.get(channel.name())).map(channel.type().messageClass()::cast);
  }

  /** All that was published on a channel, the oldest first. */
  public <T extends U2SAData> List<T> published(Channel<T> channel) {
    return all.getOrDefault(channel.name(), new ConcurrentLinkedQueue<>()).stream()
        .map(channel.type().messageClass()::cast)
        .toList();
  }

  /** Forgets what was published last on a channel. */
  public void forget(Channel<?> channel) {
    latest.remove(channel.name());
  }

  /** What health says is wrong; empty if nothing. */
  public String lastError() {
    return latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse("");
  }

  /** Sends a message as another service would. */
  public <T extends U2SAData> void send(Channel<T> channel, T message) {
    message.systemId(SYSTEM_ID);
    message.timestamp(clock.micros());
    message.freeze();
    bus.deliver(channel, message);
  }

  /** Commands an actuator. */
  public void command(String actuator, double percent) {
    send(Channels.ACTUATION, PercentageCommand.of(actuator, percent));
  }

  /** Waits until it is so, asking often. */
  public void until(Callable<Boolean> condition) {
    await().atMost(PATIENCE).pollInterval(Duration.ofMillis(50)).until(condition);
  }

  /** Ends the service. */
  public void kill() {
    if (service != null) {
      service.kill();
    }
  }

  @Override
  public void close() {
    kill();
  }
}
