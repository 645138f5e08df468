package org.u2sa.network;

import static org.awaitility.Awaitility.await;

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
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/** Somebody on the network who asks who is there, and hears how the services are. */
final class Outsider implements Receiver, AutoCloseable {
  private static final Duration UP_WITHIN = Duration.ofSeconds(120);

  /** Four heartbeats: a service that was silent for longer is not well. */
  private static final long FRESH_MICROS = Clock.micros(1.0);

  private record Heard(long atMicros, HealthReport report) {}

  private final String system;
  private final Clock clock;
  private final Connection connection;
  private final Map<String, Map<String, Heard>> health = new TreeMap<>(); // service, instance
  private final Map<String, Map<String, Losses>> lost = new TreeMap<>(); // as health, none removed
  private final Map<String, ServiceCondition> conditions = new TreeMap<>();
  private final Map<String, List<String>> answers = new TreeMap<>(); // service, instances
  private final Map<String, Long> wills = new TreeMap<>(); // service, when
  private final List<String> failsafes = new ArrayList<>();
  private boolean missionOver;
  private long navigatedMicros;
  private long longestGapMicros;

  Outsider(String address, int port, String system, Clock clock) {
    this.system = system;
    this.clock = clock;
    MessageCodec codec = new MessageCodec(MessageTypes.discovered());
    connection =
        new MqttTransport(address, port, system, codec).waiting(30.0).connect("Outsider", this);
    for (Channel<?> channel :
        List.of(
            Channels.HEALTH,
            Channels.CONDITIONS,
            Channels.DISCOVERY,
            Channels.FAILSAFE,
            Channels.GOALS,
            Channels.NAVIGATION)) {
      connection.subscribe(channel);
    }
  }

  @Override
  public synchronized void receive(Channel<?> channel, U2SAData message) {
    long now = clock.micros();
    if (message instanceof ConnectionLost lost) {
      wills.put(lost.serviceName(), now);
      instances(lost.serviceName()).remove(lost.instance().orElse(""));
    } else if (message instanceof HealthReport report) {
      String instance = report.instance().orElse("");
      instances(report.serviceName()).put(instance, new Heard(now, report));
      lost.computeIfAbsent(report.serviceName(), name -> new TreeMap<>())
          .put(instance, Losses.of(report));
    } else if (message instanceof ServiceCondition condition) {
      conditions.put(condition.serviceName(), condition);
    } else if (message instanceof DiscoveryResponse response) {
      answers
          .computeIfAbsent(response.serviceName(), name -> new ArrayList<>())
          .add(response.instance().orElse(""));
    } else if (message instanceof FailsafeState state) {
      String action = state.action().name();
      if (failsafes.isEmpty() || !failsafes.get(failsafes.size() - 1).equals(action)) {
        failsafes.add(action);
      }
    } else if (message instanceof GoalList list) {
      missionOver = list.goals().isEmpty();
    } else if (message instanceof NavigationPoint) {
      if (navigatedMicros > 0) {
        longestGapMicros = Math.max(longestGapMicros, now - navigatedMicros);
      }
      navigatedMicros = now;
    }
  }

  private Map<String, Heard> instances(String service) {
    return health.computeIfAbsent(service, name -> new TreeMap<>());
  }

  @Override
  public void trouble(String what) {
    System.out.println("outsider: " + what);
  }

  /** Asks who is there; {@link #answers} collects who says so. */
  void ask() {
    synchronized (this) {
      answers.clear();
    }
    DiscoveryRequest request = new DiscoveryRequest();
    request.systemId(system);
    request.timestamp(clock.micros());
    request.freeze();
    connection.publish(Channels.DISCOVERY, request);
  }

  /**
   * Waits until that many services answer, and returns which; asks again as long as some do not.
   */
  Set<String> awaitAll(int count) {
    await(count + " services of " + system + " answer")
        .atMost(UP_WITHIN)
        .pollInterval(Duration.ofSeconds(1))
        .until(
            () -> {
              boolean all = answered().size() == count;
              if (!all) {
                ask();
              }
              return all;
            });
    return answered();
  }

  /** Who answered the last question. */
  synchronized Set<String> answered() {
    return new TreeSet<>(answers.keySet());
  }

  /**
   * What is wrong with the directory now; empty if each service answered the last question once,
   * exactly one instance of it runs and says so, and no monitor thinks otherwise.
   */
  synchronized Optional<String> wrong(Set<String> expected) {
    if (!answers.keySet().equals(expected)) {
      return Optional.of("answered: " + answers.keySet() + " instead of " + expected);
    }
    return expected.stream().flatMap(service -> wrongWith(service).stream()).findFirst();
  }

  private Optional<String> wrongWith(String service) {
    long now = clock.micros();
    List<String> answered = answers.get(service);
    List<String> running = new ArrayList<>();
    instances(service)
        .forEach(
            (instance, heard) -> {
              boolean fresh = now - heard.atMicros < FRESH_MICROS;
              boolean itself = heard.report.threadAlive().isEmpty();
              if (fresh && itself && heard.report.status() == ServiceStatus.RUNNING) {
                running.add(instance);
              }
            });
    if (answered.size() != 1) {
      return Optional.of(service + " answered " + answered.size() + " times: " + answered);
    }
    if (!running.equals(answered)) {
      return Optional.of(service + " runs as " + running + " and answered as " + answered);
    }
    return Optional.ofNullable(conditions.get(service))
        .filter(told -> told.condition() != Condition.ALIVE)
        .map(told -> service + " is taken for " + told.condition());
  }

  /** Whether the health monitor thinks that a service is lost. */
  synchronized boolean isTakenForLost(String service) {
    return Optional.ofNullable(conditions.get(service))
        .filter(told -> told.condition() == Condition.LOST)
        .isPresent();
  }

  /** When the broker said that a service's connection broke, if it did since then. */
  synchronized Optional<Long> will(String service, long sinceMicros) {
    return Optional.ofNullable(wills.get(service)).filter(at -> at >= sinceMicros);
  }

  /** Sums of what all services counted, of all instances that were ever heard. */
  synchronized Losses losses() {
    return lost.values().stream()
        .flatMap(instances -> instances.values().stream())
        .reduce(Losses.NONE, Losses::plus);
  }

  /** Services of which there were not two instances, if started again, or one. */
  synchronized List<String> wrongInstances(Set<String> startedAnew) {
    List<String> wrong = new ArrayList<>();
    lost.forEach(
        (service, instances) -> {
          if (instances.size() != (startedAnew.contains(service) ? 2 : 1)) {
            wrong.add(service + " ran as " + instances.keySet());
          }
        });
    return wrong;
  }

  /** Begins to measure the longest time without a navigation point. */
  synchronized void measureGap() {
    longestGapMicros = 0;
  }

  /** The longest time without one since then; one that lasts counts too. */
  synchronized double longestGapS() {
    long lastsMicros = navigatedMicros > 0 ? clock.micros() - navigatedMicros : 0;
    return Clock.seconds(Math.max(longestGapMicros, lastsMicros));
  }

  /** Restarts that the health monitor has had done, of all services. */
  synchronized long restarts() {
    return conditions.values().stream().mapToLong(ServiceCondition::restarts).sum();
  }

  /** The failsafe actions in the order in which they were told, each as long as it held. */
  synchronized List<String> failsafes() {
    return List.copyOf(failsafes);
  }

  /** The failsafe action that was told last. */
  synchronized String failsafe() {
    return failsafes.isEmpty() ? "" : failsafes.get(failsafes.size() - 1);
  }

  synchronized boolean isMissionOver() {
    return missionOver;
  }

  @Override
  public void close() {
    connection.close();
  }
}
