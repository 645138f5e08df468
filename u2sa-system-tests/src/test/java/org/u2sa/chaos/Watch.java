package org.u2sa.chaos;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/** An outsider beside the broker who hears how the services are. Safe for all threads. */
final class Watch implements Receiver, AutoCloseable {
  /** Four heartbeats: a service that was silent for longer is not well. */
  private static final long FRESH_MICROS = Clock.micros(1.0);

  /** A condition that was told, and when. */
  record Told(long atMicros, ServiceCondition condition) {}

  private record Heard(long atMicros, HealthReport report) {}

  private final Clock clock;
  private final Connection connection;
  private final Map<String, Map<String, Heard>> health = new TreeMap<>(); // service, instance
  private final List<Told> conditions = new ArrayList<>();
  private final List<String> troubles = new ArrayList<>();
  private final Set<String> failsafes = new TreeSet<>();

  Watch(int brokerPort, Clock clock) {
    this.clock = clock;
    MessageCodec codec = new MessageCodec(MessageTypes.discovered());
    connection = new MqttTransport("127.0.0.1", brokerPort, "cessna", codec).connect("Watch", this);
    connection.subscribe(Channels.HEALTH);
    connection.subscribe(Channels.CONDITIONS);
    connection.subscribe(Channels.FAILSAFE);
  }

  @Override
  public synchronized void receive(Channel<?> channel, U2SAData message) {
    long now = clock.micros();
    if (message instanceof ConnectionLost lost) {
      instances(lost.serviceName()).remove(lost.instance().orElse(""));
    } else if (message instanceof HealthReport report) {
      Map<String, Heard> instances = instances(report.serviceName());
      instances.values().removeIf(heard -> now - heard.atMicros > 10 * FRESH_MICROS);
      instances.put(report.instance().orElse(""), new Heard(now, report));
    } else if (message instanceof ServiceCondition condition) {
      conditions.add(new Told(now, condition));
    } else if (message instanceof FailsafeState state) {
      failsafes.add(state.action().name());
    }
  }

  private Map<String, Heard> instances(String service) {
    return health.computeIfAbsent(service, name -> new TreeMap<>());
  }

  @Override
  public synchronized void trouble(String what) {
    troubles.add(what);
  }

  /** Every service that was ever heard. */
  synchronized Set<String> services() {
    return new TreeSet<>(health.keySet());
  }

  /** What is wrong with a service now; empty if exactly one instance of it runs and says so. */
  synchronized Optional<String> wrongWith(String service) {
    long now = clock.micros();
    List<HealthReport> fresh =
        instances(service).values().stream()
            .filter(heard -> now - heard.atMicros < FRESH_MICROS)
            .map(Heard::report)
            .filter(report -> report.status() == ServiceStatus.RUNNING)
            .toList();
    if (fresh.size() != 1) {
      return Optional.of(service + ": " + fresh.size() + " instances run");
    }
    return fresh.get(0).threadAlive().map(alive -> service + ": is spoken for");
  }

  /** The instance of a service that was heard last. */
  synchronized String instance(String service) {
    return instances(service).entrySet().stream()
        .max((a, b) -> Long.compare(a.getValue().atMicros, b.getValue().atMicros))
        .map(Map.Entry::getKey)
        .orElse("");
  }

  /** The newest report of a service. */
  synchronized Optional<HealthReport> report(String service) {
    return Optional.ofNullable(instances(service).get(instance(service))).map(Heard::report);
  }

  /** The first condition other than ALIVE that was told of a service since then. */
  synchronized Optional<Told> firstTrouble(String service, long sinceMicros) {
    return conditions.stream()
        .filter(told -> told.atMicros >= sinceMicros)
        .filter(told -> told.condition.serviceName().equals(service))
        .filter(told -> told.condition.condition() != Condition.ALIVE)
        .findFirst();
  }

  /** The failsafe actions that were ever told. */
  synchronized Set<String> failsafes() {
    return new TreeSet<>(failsafes);
  }

  /** What this outsider's own connection met with. */
  synchronized List<String> troubles() {
    return List.copyOf(troubles);
  }

  /** How long a silence may last. */
  static Duration fresh() {
    return Duration.ofNanos(FRESH_MICROS * 1_000);
  }

  @Override
  public void close() {
    connection.close();
  }
}
