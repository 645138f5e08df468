package org.u2sa.gcs.mavlink.vehicle;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.schema.U2SAData;

/**
 * Orders of all stations that wait for the vehicle's answer. Each is answered once, on the thread
 * that calls {@link #step}: by the vehicle, or with a failure after 3 s. Orders to stop or disarm
 * are not given up so soon: the station hears that they are in progress, for up to 30 s, and they
 * are published again while the broker has not forwarded them.
 *
 * <p>Every station has places of its own for every kind of order, so that no station and no bulk of
 * changes keeps an order to stop, hold or disarm waiting. Stops and arming are published at once.
 * Of the others, the broker refuses what a client sends beyond its rate: they are published more
 * slowly, and the stations take turns. A station's own stay in order, so that none to hold is
 * followed by an older one to go on; only parameters let all others pass.
 */
public final class OrdersUnderWay {
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

  /** Kinds of orders, each with places of its own. */
  enum Kind {
    STOP(Urgency.AT_ONCE),
    DISARM(Urgency.AT_ONCE),
    ARM(Urgency.AT_ONCE),
    RELEASE(Urgency.SOON), // end driving by hand
    HOLD(Urgency.SOON), // or return, or land
    DRIVE(Urgency.SOON), // by hand
    OTHER(Urgency.SOON),
    CONFIGURE(Urgency.LATER);

    private final Urgency urgency;

    Kind(Urgency urgency) {
      this.urgency = urgency;
    }

    /** Whether a station that hears too early that the order failed may rely on a wrong state. */
    boolean isPersistent() {
      return this == STOP || this == DISARM;
    }
  }

  private enum Urgency {
    AT_ONCE,
    SOON,
    LATER
  }

  /** An order that has not been published. */
  record Order(
      String id,
      VehicleOrders station,
      Kind kind,
      Channel<?> channel,
      U2SAData message,
      VehicleOrders.Answer answer) {}

  private enum Outcome {
    ACCEPTED,
    DENIED,
    FAILED
  }

  private record Result(String id, Outcome outcome, String text) {}

  private static final int PLACES = 32; // of a station, for a kind
  private static final int MAX_STATIONS = 16;
  private static final double PER_S = 25.0; // half of the broker's; a long one counts as several
  private static final double BURST = 10.0;
  private static final double REPETITIONS_PER_S = 4.0;

  private final Publisher publisher;
  private final String operator;
  private final Map<String, OrderUnderWay> pending = new ConcurrentHashMap<>();
  private final Queue<Result> results = new ConcurrentLinkedQueue<>();
  private final String stopId; // the same for all: stations repeat a stop until it is acknowledged
  private final Turns<Order> soon = new Turns<>();
  private final Turns<Order> later = new Turns<>();
  private final Allowance allowance = new Allowance(PER_S, BURST, 0L);
  private final Allowance stops = new Allowance(REPETITIONS_PER_S, 0L);
  private final Allowance repetitions = new Allowance(REPETITIONS_PER_S, 0L); // of other orders
  private final Allowance questions = new Allowance(1.0, 0L);
  private long nowMicros;

  /**
   * @param operator author of the orders, as the vehicle logs it
   */
  public OrdersUnderWay(Publisher publisher, String operator) {
    this.publisher = publisher;
    this.operator = operator;
    stopId = operator + " " + UUID.randomUUID();
  }

  String operator() {
    return operator;
  }

  String stopId() {
    return stopId;
  }

  /**
   * Name of a person at a station, as the vehicle logs it.
   *
   * @param connection the station's own: most stations have the same MAVLink system ID
   */
  public String driver(String connection, int station) {
    return operator + " station " + station + " " + connection;
  }

  /** Publishes a message that expects no answer. */
  public void tell(Channel<?> channel, U2SAData message) {
    publisher.publish(channel, message);
  }

  void send(
      VehicleOrders station,
      Kind kind,
      String id,
      Channel<?> channel,
      U2SAData message,
      VehicleOrders.Answer answer) {
    if (!station.takePlace(kind, PLACES)) {
      answer.done(false, "too many orders at once");
      return;
    }
    Order order = new Order(id, station, kind, channel, message, answer);
    switch (kind.urgency) {
      case AT_ONCE -> publish(order);
      case SOON -> soon.add(station, order);
      case LATER -> later.add(station, order);
    }
    publishDue();
  }

  private void publishDue() {
    while (!(soon.isEmpty() && later.isEmpty()) && allowance.isOpen(nowMicros)) {
      allowance.take(1.0);
      publish(soon.isEmpty() ? later.next() : soon.next());
    }
  }

  private void publish(Order order) {
    makeRoom();
    OrderUnderWay begun = new OrderUnderWay(order, nowMicros);
    pending.put(order.id(), begun);
    try {
      begun.publish(publisher);
    } catch (CommunicationException e) {
      if (!order.kind().isPersistent()) {
        results.add(new Result(order.id(), Outcome.FAILED, e.getMessage()));
      }
    }
  }

  /** Drops what a station has ordered and has not been published. */
  void forget(VehicleOrders station) {
    soon.remove(station);
    later.remove(station);
  }

  /** Stations that come, order and leave do not fill the memory: their oldest order gives way. */
  private void makeRoom() {
    if (pending.size() >= MAX_STATIONS * PLACES * Kind.values().length) {
      pending.entrySet().stream()
          .filter(each -> each.getValue().order().station().isClosed())
          .min(Comparator.comparingLong(each -> each.getValue().sinceMicros()))
          .ifPresent(oldest -> end(oldest.getKey(), Outcome.DENIED, "its station has left"));
    }
  }

  private void end(String id, Outcome outcome, String text) {
    OrderUnderWay asked = pending.remove(id);
    if (asked == null) { // the first answer counts
      return;
    }
    Order order = asked.order();
    order.station().leavePlace(order.kind());
    if (outcome == Outcome.FAILED) {
      order.answer().failed(text);
    } else {
      order.answer().done(outcome == Outcome.ACCEPTED, text);
    }
  }

  /** Takes a message that may be an answer; on any thread. */
  void take(U2SAData message) {
    if (message instanceof MissionOrderResult result) {
      answered(result.requestId(), result.accepted(), result.outcome());
    } else if (message instanceof FenceOrderResult result) {
      answered(result.requestId(), result.accepted(), result.outcome());
    } else if (message instanceof ConfigurationTransactionResult result) {
      if (isAsked(result)) {
        answered(result.requestId(), result.accepted(), result.reason());
      }
    } else if (message instanceof ServiceOrderResult result) {
      answered(result.requestId(), result.accepted(), result.reason());
    } else if (message instanceof ArmingState state && state.requestId().isPresent()) {
      String id = state.requestId().get();
      OrderUnderWay asked = pending.get(id);
      if (asked != null) {
        boolean isArm = asked.order().kind() == Kind.ARM;
        boolean isRefused = isArm && !state.reasons().isEmpty(); // perhaps armed before
        boolean isDone = state.armed() == isArm && !isRefused;
        answered(id, isDone, String.join("; ", state.reasons()));
      }
    } else if (message instanceof ManualState state && state.requestId().isPresent()) {
      OrderUnderWay asked = pending.get(state.requestId().get());
      if (asked != null) {
        answered(
            state.requestId().get(),
            state.active() == (asked.order().kind() == Kind.DRIVE),
            state.reason().orElse(""));
      }
    } else if (message instanceof HealthReport report
        && report.emergencyStops().orElse(List.of()).contains(stopId)) {
      String by = "in force at " + report.serviceName();
      pending.forEach(
          (id, asked) -> {
            if (asked.order().kind() == Kind.STOP) {
              answered(id, true, by);
            }
          });
    } else {
      pending.values().forEach(each -> each.take(message));
    }
  }

  /** Whether the answer comes from the service that was to change. */
  private boolean isAsked(ConfigurationTransactionResult result) {
    OrderUnderWay asked = pending.get(result.requestId());
    return asked != null
        && asked.order().message() instanceof ConfigurationTransaction change
        && change.serviceName().equals(result.serviceName());
  }

  private void answered(String id, boolean accepted, String text) {
    if (pending.containsKey(id)) {
      results.add(new Result(id, accepted ? Outcome.ACCEPTED : Outcome.DENIED, text));
    }
  }

  /** Delivers answers. */
  public void step(long micros) {
    nowMicros = micros;
    for (Result result = results.poll(); result != null; result = results.poll()) {
      end(result.id(), result.outcome(), result.text());
    }
    pending.forEach(this::look);
    publishDue();
  }

  private void look(String id, OrderUnderWay asked) {
    boolean isPersistent = asked.order().kind().isPersistent();
    if (asked.isRefused()) {
      end(
          id,
          Outcome.DENIED,
          "the broker forwards no orders of the bridge's user: it lacks the role operator");
    } else if (asked.isOver(nowMicros)) {
      end(id, isPersistent ? Outcome.FAILED : Outcome.DENIED, asked.whyOver());
    } else if (isPersistent && asked.isDue(nowMicros)) {
      asked.order().answer().inProgress();
      repeat(asked);
    }
  }

  /** Publishes an order again where necessary; all stops are the same one. */
  private void repeat(OrderUnderWay asked) {
    boolean isStop = asked.order().kind() == Kind.STOP;
    Allowance allowed = isStop ? stops : repetitions;
    try {
      if (asked.isToAsk(nowMicros) && questions.isOpen(nowMicros)) {
        questions.take(1.0);
        asked.ask(publisher);
      } else if (asked.isToRepeat() && allowed.isOpen(nowMicros)) {
        allowed.take(1.0);
        asked.publish(publisher);
      }
    } catch (CommunicationException e) {
      return; // tried again; the last failure is reported in the end
    }
  }
}
