package org.u2sa.gcs.mavlink.vehicle;

import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.U2SAData;

/**
 * Orders to the vehicle. Each is answered once, on the thread that calls {@link #step}: by the
 * vehicle's answer, or with a failure after {@link #ANSWER_WITHIN_MICROS}.
 */
public final class VehicleOrders {
  /** Publishes a message of the vehicle's channels. */
  @FunctionalInterface
  public interface Publisher {
    /**
     * Publishes.
     *
     * @throws CommunicationException if the message was not accepted
     */
    void publish(Channel<?> channel, U2SAData message);
  }

  /** Receives the result of an order. */
  @FunctionalInterface
  public interface Answer {
    /**
     * Called once.
     *
     * @param text what was done, or the reason for the failure
     */
    void done(boolean accepted, String text);
  }

  private enum Kind {
    ARM, // or drive by hand
    DISARM,
    STOP,
    OTHER
  }

  private record Pending(long deadlineMicros, Kind kind, Answer answer) {}

  private record Result(String id, boolean accepted, String text) {}

  private static final long ANSWER_WITHIN_MICROS = 3_000_000;
  private static final int MAX_PENDING = 32;

  private final Publisher publisher;
  private final String operator;
  private final Map<String, Pending> pending = new ConcurrentHashMap<>();
  private final Queue<Result> results = new ConcurrentLinkedQueue<>();
  private final String stopId; // the same for all: stations repeat a stop until it is acknowledged
  private long nowMicros;

  /**
   * @param operator author of the orders, as the vehicle logs it
   */
  public VehicleOrders(Publisher publisher, String operator) {
    this.publisher = publisher;
    this.operator = operator;
    stopId = operator + " " + UUID.randomUUID();
  }

  /** Arms or disarms. */
  public void arm(boolean arm, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(
        id,
        arm ? Kind.ARM : Kind.DISARM,
        Channels.ARMING,
        new ArmCommand().requestId(id).arm(arm).operator(operator),
        answer);
  }

  /** Stops the vehicle; accepted once a service reports that the stop is in force. */
  public void stop(String reason, Answer answer) {
    send(
        UUID.randomUUID().toString(),
        Kind.STOP,
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).operator(operator).reason(reason).stopId(stopId),
        answer);
  }

  /** Changes the mission. */
  public void mission(MissionOrder order, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(id, Kind.OTHER, Channels.MISSION, order.requestId(id).operator(operator), answer);
  }

  /**
   * Replaces the Path Planner's class.
   *
   * @param index index of a class; empty: that of the mode Mission
   */
  public void plan(PlannerModes planners, Optional<Integer> index, Answer answer) {
    String id = UUID.randomUUID().toString();
    ServiceOrder order =
        new ServiceOrder()
            .requestId(id)
            .serviceName(planners.service())
            .action(ServiceAction.SWAP)
            .className(planners.className(index))
            .operator(operator);
    send(
        id,
        Kind.OTHER,
        Channels.SERVICE_ORDERS,
        order,
        (swapped, why) -> {
          tell(Channels.DISCOVERY, new DiscoveryRequest());
          answer.done(swapped, why);
        });
  }

  /**
   * Begins or ends driving by hand.
   *
   * @param driver name of the driver
   */
  public void manual(boolean active, String driver, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(
        id,
        active ? Kind.ARM : Kind.DISARM,
        Channels.MANUAL_ORDERS,
        new ManualOrder().requestId(id).active(active).operator(driver),
        answer);
  }

  /**
   * Name of a person at a station, as the vehicle logs it.
   *
   * @param connection the station's own: most stations have the same MAVLink system ID
   */
  public String driver(String connection, int station) {
    return operator + " station " + station + " " + connection;
  }

  /** Changes the fence. */
  public void fence(FenceOrder order, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(id, Kind.OTHER, Channels.FENCE_ORDERS, order.requestId(id).operator(operator), answer);
  }

  public void configure(ConfigurationTransaction change, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(id, Kind.OTHER, Channels.CONFIGURATION, change.requestId(id).author(operator), answer);
  }

  /** Publishes a message that expects no answer. */
  public void tell(Channel<?> channel, U2SAData message) {
    publisher.publish(channel, message);
  }

  private void send(String id, Kind kind, Channel<?> channel, U2SAData order, Answer answer) {
    if (pending.size() >= MAX_PENDING && kind != Kind.STOP) {
      answer.done(false, "too many orders at once");
      return;
    }
    pending.put(id, new Pending(nowMicros + ANSWER_WITHIN_MICROS, kind, answer));
    try {
      publisher.publish(channel, order);
    } catch (CommunicationException e) {
      results.add(new Result(id, false, e.getMessage()));
    }
  }

  /** Takes a message that may be an answer; on any thread. */
  void take(U2SAData message) {
    if (message instanceof MissionOrderResult result) {
      answered(result.requestId(), result.accepted(), result.outcome());
    } else if (message instanceof FenceOrderResult result) {
      answered(result.requestId(), result.accepted(), result.outcome());
    } else if (message instanceof ConfigurationTransactionResult result) {
      answered(result.requestId(), result.accepted(), result.reason());
    } else if (message instanceof ServiceOrderResult result) {
      answered(result.requestId(), result.accepted(), result.reason());
    } else if (message instanceof ArmingState state && state.requestId().isPresent()) {
      String id = state.requestId().get();
      Pending asked = pending.get(id);
      if (asked != null) {
        boolean isDone = state.armed() == (asked.kind() == Kind.ARM);
        answered(id, isDone, String.join("; ", state.reasons()));
      }
    } else if (message instanceof ManualState state && state.requestId().isPresent()) {
      Pending asked = pending.get(state.requestId().get());
      if (asked != null) {
        answered(
            state.requestId().get(),
            state.active() == (asked.kind() == Kind.ARM),
            state.reason().orElse(""));
      }
    } else if (message instanceof HealthReport report
        && report.emergencyStops().orElse(List.of()).contains(stopId)) {
      String by = "in force at " + report.serviceName();
      pending.forEach(
          (id, asked) -> {
            if (asked.kind() == Kind.STOP) {
              answered(id, true, by);
            }
          });
    }
  }

  private void answered(String id, boolean accepted, String text) {
    if (pending.containsKey(id)) {
      results.add(new Result(id, accepted, text));
    }
  }

  /** Delivers answers. */
  public void step(long micros) {
    nowMicros = micros;
    for (Result result = results.poll(); result != null; result = results.poll()) {
      Pending asked = pending.remove(result.id());
      if (asked != null) { // the first answer counts
        asked.answer().done(result.accepted(), result.text());
      }
    }
    Iterator<Pending> waiting = pending.values().iterator();
    while (waiting.hasNext()) {
      Pending asked = waiting.next();
      if (micros > asked.deadlineMicros()) {
        waiting.remove();
        asked
            .answer()
            .done(
                false,
                "no answer from the vehicle: the bridge's user may lack the role operator, or no service there handles it");
      }
    }
  }
}
