package org.u2sa.service.inbox;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.schema.U2SAData;

/**
 * A service's bounded message queue. Any thread may put; the service's thread takes.
 *
 * <p>On latest-value channels, a message replaces the queued one of the same source in its
 * position, so a slow service sees fresh data and a flood costs no memory. A full queue rejects the
 * newest. Both are counted separately, because only the latter is a loss. Urgent messages
 * (emergency stops) have a separate queue with priority. Arming and failsafes wait among the
 * others, but the others cannot take their room. Questions that anybody may ask, which the service
 * contract answers, fill a quarter of the rest at most.
 *
 * <p>Services keep state per source of a channel, so the inbox limits the number of sources, lest
 * invented names exhaust memory; likewise the bytes of waiting messages from other processes.
 */
public final class ServiceInbox {
  /** A message and its channel. */
  public static final class Delivery {
    private final Channel<?> channel;
    private U2SAData message; // replaceable while queued; guarded by the inbox
    private long arrivedMicros; // likewise

    /** A message on its channel, with its time of arrival [µs]. */
    public Delivery(Channel<?> channel, U2SAData message, long arrivedMicros) {
      this.channel = channel;
      this.message = message;
      this.arrivedMicros = arrivedMicros;
    }

    /** Channel of the message. */
    public Channel<?> channel() {
      return channel;
    }

    /** The message. */
    public U2SAData message() {
      return message;
    }

    /** Time of arrival [µs]. */
    public long arrivedMicros() {
      return arrivedMicros;
    }
  }

  /** Sources of a channel whose messages it takes: the first that it gets. */
  public static final int MAX_SOURCES = 500;

  /** Outcome of queueing a message. */
  public enum Outcome {
    /** Queued. */
    KEPT,
    /** Lost: the queue is full, or its messages take too much memory. */
    DROPPED,
    /** Lost: too many sources. */
    UNKNOWN_SOURCE
  }

  private static final int QUESTIONS_PART = 4;
  private static final long MAX_BYTES =
      Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 64); // several of the longest messages
  private static final Delivery NONE_WAITS = new Delivery(null, null, 0L);

  private final int capacity;
  private final ArrayDeque<Delivery> queue = new ArrayDeque<>();
  private final ArrayDeque<Delivery> urgent = new ArrayDeque<>();
  private final Map<Channel<?>, Map<String, Delivery>> newest =
      new HashMap<>(); // queued deliveries of each known source
  private final Map<Channel<?>, Set<String>> sources =
      new HashMap<>(); // of channels on which no message may be lost
  private int reserved; // number in the queue, as the next ones
  private int questions;
  private long bytes; // of waiting messages from other processes
  private long dropped;
  private long replaced;
  private ServiceInbox successor; // null until messages are forwarded

  /** An empty inbox for this many messages. */
  public ServiceInbox(int capacity) {
    this.capacity = capacity;
  }

  /**
   * Queues a message if there is space.
   *
   * @param arrivedMicros time of arrival, if needed [µs]
   */
  public synchronized Outcome put(Channel<?> channel, U2SAData message, long arrivedMicros) {
    if (successor != null) {
      return successor.put(channel, message, arrivedMicros);
    }
    String source = channel.sourceOf(message);
    if (channel.deliversEvery()) {
      if (!source.isEmpty() && !isKnown(channel, source)) {
        dropped++;
        return Outcome.UNKNOWN_SOURCE;
      }
      return enqueue(lineOf(channel), new Delivery(channel, message, arrivedMicros));
    }
    Map<String, Delivery> ofChannel = newest.computeIfAbsent(channel, key -> new HashMap<>());
    Delivery waiting = ofChannel.get(source);
    if (waiting == null && ofChannel.size() >= MAX_SOURCES) {
      dropped++;
      return Outcome.UNKNOWN_SOURCE;
    }
    if (waiting != null && waiting != NONE_WAITS) {
      int more = message.receivedBytes() - waiting.message.receivedBytes();
      if (isTooMuch(channel, more)) {
        dropped++;
        return Outcome.DROPPED;
      }
      bytes += more;
      waiting.message = message;
      waiting.arrivedMicros = arrivedMicros;
      replaced++;
      return Outcome.KEPT;
    }
    Delivery delivery = new Delivery(channel, message, arrivedMicros);
    Outcome outcome = enqueue(lineOf(channel), delivery);
    if (outcome == Outcome.KEPT) {
      ofChannel.put(source, delivery);
    }
    return outcome;
  }

  private boolean isKnown(Channel<?> channel, String source) {
    Set<String> known = sources.computeIfAbsent(channel, key -> new HashSet<>());
    return known.contains(source) || known.size() < MAX_SOURCES && known.add(source);
  }

  private ArrayDeque<Delivery> lineOf(Channel<?> channel) {
    return channel.isUrgent() ? urgent : queue;
  }

  private boolean isFull(ArrayDeque<Delivery> line, Delivery delivery) {
    if (line == urgent) {
      return urgent.size() >= capacity;
    }
    return delivery.channel.reservesRoom()
        ? reserved >= capacity
        : queue.size() - reserved >= capacity
            || isQuestion(delivery.message) && questions >= Math.max(1, capacity / QUESTIONS_PART);
  }

  private boolean isTooMuch(Channel<?> channel, int more) {
    boolean isLimited = !channel.isUrgent() && !channel.reservesRoom();
    return isLimited && more > 0 && bytes + more > MAX_BYTES;
  }

  /** Counts a delivery that enters or leaves the queues. */
  private void count(Delivery delivery, int sign) {
    bytes += sign * delivery.message.receivedBytes();
    if (delivery.channel.reservesRoom() && !delivery.channel.isUrgent()) {
      reserved += sign;
    } else if (isQuestion(delivery.message)) {
      questions += sign;
    }
  }

  private static boolean isQuestion(U2SAData message) {
    return message instanceof ConfigurationRequest
        || message instanceof DiscoveryRequest
        || message instanceof FunctionalityRequest;
  }

  private Outcome enqueue(ArrayDeque<Delivery> line, Delivery delivery) {
    if (isFull(line, delivery) || isTooMuch(delivery.channel, delivery.message.receivedBytes())) {
      dropped++;
      return Outcome.DROPPED;
    }
    count(delivery, 1);
    line.add(delivery);
    return Outcome.KEPT;
  }

  /** The oldest delivery, urgent ones first; null if none. */
  public synchronized Delivery poll() {
    Delivery delivery = urgent.isEmpty() ? queue.poll() : urgent.poll();
    if (delivery == null) {
      return null;
    }
    if (!delivery.channel.deliversEvery()) {
      newest.get(delivery.channel).put(delivery.channel.sourceOf(delivery.message), NONE_WAITS);
    }
    count(delivery, -1);
    return delivery;
  }

  /**
   * Moves all waiting messages, and forwards all later ones, to a successor's inbox, ahead of those
   * already waiting there: nothing is lost, even beyond its capacity, and nothing is duplicated.
   *
   * @param handled already handled messages that the successor must see, unless a newer one is
   *     waiting
   */
  public synchronized void moveTo(ServiceInbox next, Iterable<Delivery> handled) {
    synchronized (next) {
      ArrayDeque<Delivery> ahead = new ArrayDeque<>(next.urgent);
      ahead.addAll(next.queue);
      next.urgent.clear();
      next.queue.clear();
      next.newest.clear();
      next.questions = 0;
      next.bytes = 0;
      next.reserved = 0;
      for (Delivery delivery : handled) {
        if (!isWaiting(delivery)) {
          next.append(delivery);
        }
      }
      urgent.forEach(next::append);
      queue.forEach(next::append);
      ahead.forEach(next::append);
      next.dropped += dropped;
      next.replaced += replaced;
      urgent.clear();
      queue.clear();
      newest.clear();
      questions = 0;
      bytes = 0;
      reserved = 0;
      successor = next;
    }
  }

  private boolean isWaiting(Delivery handled) {
    Delivery waiting =
        newest
            .getOrDefault(handled.channel, Map.of())
            .getOrDefault(handled.channel.sourceOf(handled.message), NONE_WAITS);
    return waiting != NONE_WAITS;
  }

  private void append(Delivery delivery) {
    lineOf(delivery.channel).add(delivery);
    count(delivery, 1);
    if (!delivery.channel.deliversEvery()) {
      newest
          .computeIfAbsent(delivery.channel, key -> new HashMap<>())
          .put(delivery.channel.sourceOf(delivery.message), delivery);
    }
  }

  /** Number of messages that wait. */
  public synchronized int depth() {
    return urgent.size() + queue.size();
  }

  /** Messages lost so far, because the queue was full or the source limit was exceeded. */
  public synchronized long dropped() {
    return dropped;
  }

  /** Number of messages replaced by newer ones of the same source before being handled. */
  public synchronized long replaced() {
    return replaced;
  }
}
