package org.u2sa.service.inbox;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.schema.U2SAData;

/**
 * A service's bounded message queue. Any thread may put; the service's thread takes.
 *
 * <p>On latest-value channels, a message replaces the queued message of the same source, in its
 * queue position. A full queue rejects the newest. Both are counted separately, because only the
 * latter is a loss. Urgent messages (emergency stops) have a separate queue with priority. Arming
 * and failsafes wait among the others, but in reserved room. Requests of the service contract fill
 * at most a quarter of the rest.
 *
 * <p>Also limits the number of sources and the memory of their last messages ({@link
 * KnownSources}), and the memory of waiting messages from other processes, so that invented names
 * cannot exhaust it.
 */
public final class ServiceInbox {
  public static final class Delivery {
    private final Channel<?> channel;
    private U2SAData message; // replaceable while queued; guarded by the inbox
    private long arrivedMicros; // likewise
    private KnownSources.Source<Delivery>
        source; // source whose latest message it is; null on channels that keep every message

    public Delivery(Channel<?> channel, U2SAData message, long arrivedMicros) {
      this.channel = channel;
      this.message = message;
      this.arrivedMicros = arrivedMicros;
    }

    public Channel<?> channel() {
      return channel;
    }

    public U2SAData message() {
      return message;
    }

    /** Time of arrival [µs]. */
    public long arrivedMicros() {
      return arrivedMicros;
    }
  }

  /** Maximum number of sources accepted per channel at a time. */
  public static final int MAX_SOURCES = 500;

  public enum Outcome {
    /** Queued. */
    KEPT,
    /** Lost: the queue is full, or its messages take too much memory. */
    DROPPED,
    /** Lost: too many sources. */
    UNKNOWN_SOURCE,
    /** Lost: the last messages of all sources take too much memory. */
    TOO_LONG
  }

  private static final int QUESTIONS_PART = 4;
  private static final long MAX_BYTES =
      Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 64); // several of the longest messages
  private static final long MAX_LAST_BYTES = // of a channel's sources, each of which services keep
      Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 32);

  private final int capacity;
  private final long maxBytes;
  private final Clock clock;
  private final ArrayDeque<Delivery> queue = new ArrayDeque<>();
  private final ArrayDeque<Delivery> urgent = new ArrayDeque<>();
  private final Map<Channel<?>, KnownSources<Delivery>> sources = new HashMap<>();
  private int reserved; // sequence numbers in the queue, like the next fields
  private int questions;
  private long bytes; // of waiting messages from other processes
  private long dropped;
  private long replaced;
  private ServiceInbox successor; // null until messages are forwarded

  /**
   * @param capacity number of messages
   * @param clock for the silence of sources
   */
  public ServiceInbox(int capacity, Clock clock) {
    this(capacity, clock, MAX_BYTES);
  }

  /**
   * @param maxBytes memory of waiting messages from other processes; a single one may be longer
   */
  ServiceInbox(int capacity, Clock clock, long maxBytes) {
    this.capacity = capacity;
    this.maxBytes = maxBytes;
    this.clock = clock;
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
    String name = channel.sourceOf(message);
    if (channel.deliversEvery() && name.isEmpty()) {
      return enqueue(lineOf(channel), new Delivery(channel, message, arrivedMicros));
    }
    KnownSources<Delivery> known = sourcesOf(channel);
    KnownSources.Source<Delivery> source = known.heard(name);
    Outcome refusal = refusal(known, source, name, message);
    if (refusal != Outcome.KEPT) {
      dropped++;
      return refusal;
    }
    Delivery waiting = source == null ? null : source.waiting();
    Outcome outcome =
        waiting == null
            ? enqueue(lineOf(channel), new Delivery(channel, message, arrivedMicros))
            : replace(waiting, message, arrivedMicros);
    if (outcome == Outcome.KEPT) {
      KnownSources.Source<Delivery> its = source == null ? known.add(name) : source;
      if (!name.isEmpty()) {
        known.takes(its, message.receivedBytes());
      }
      if (waiting == null && !channel.deliversEvery()) {
        waits(lineOf(channel).peekLast(), its);
      }
    }
    return outcome;
  }

  private static void waits(Delivery latest, KnownSources.Source<Delivery> source) {
    source.waiting(latest);
    latest.source = source;
  }

  private KnownSources<Delivery> sourcesOf(Channel<?> channel) {
    return sources.computeIfAbsent(
        channel, key -> new KnownSources<>(clock, MAX_SOURCES, MAX_LAST_BYTES));
  }

  /** {@link Outcome#KEPT} if the source does not matter or may send this. */
  private static Outcome refusal(
      KnownSources<Delivery> known,
      KnownSources.Source<Delivery> source,
      String name,
      U2SAData message) {
    if (source == null && !known.hasRoom()) {
      return Outcome.UNKNOWN_SOURCE;
    }
    boolean isSingle = name.isEmpty(); // the channel has one source, whose message has a slot
    return isSingle || known.makesRoom(source, message.receivedBytes())
        ? Outcome.KEPT
        : Outcome.TOO_LONG;
  }

  private Outcome replace(Delivery waiting, U2SAData message, long arrivedMicros) {
    int more = message.receivedBytes() - waiting.message.receivedBytes();
    if (isTooMuch(waiting.channel, more)) {
      dropped++;
      return Outcome.DROPPED;
    }
    bytes += more;
    waiting.message = message;
    waiting.arrivedMicros = arrivedMicros;
    replaced++;
    return Outcome.KEPT;
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
    return isLimited && more > 0 && bytes > 0 && bytes + more > maxBytes; // one always fits
  }

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

  /** The oldest delivery, urgent ones first, or null. */
  public synchronized Delivery poll() {
    Delivery delivery = urgent.isEmpty() ? queue.poll() : urgent.poll();
    if (delivery == null) {
      return null;
    }
    if (delivery.source != null) {
      delivery.source.waiting(null);
    }
    count(delivery, -1);
    return delivery;
  }

  /**
   * Moves all waiting messages, and forwards all later ones, to a successor's inbox, ahead of those
   * already there and even beyond its capacity.
   *
   * @param handled handled messages that the successor must see, unless a newer one is waiting
   */
  public synchronized void moveTo(ServiceInbox next, Iterable<Delivery> handled) {
    synchronized (next) {
      ArrayDeque<Delivery> ahead = new ArrayDeque<>(next.urgent);
      ahead.addAll(next.queue);
      next.urgent.clear();
      next.queue.clear();
      next.sources.clear();
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
      sources.clear();
      questions = 0;
      bytes = 0;
      reserved = 0;
      successor = next;
    }
  }

  private boolean isWaiting(Delivery handled) {
    String name = handled.channel.sourceOf(handled.message);
    KnownSources.Source<Delivery> source = sourcesOf(handled.channel).heard(name);
    return source != null && source.waiting() != null;
  }

  private void append(Delivery delivery) {
    lineOf(delivery.channel).add(delivery);
    count(delivery, 1);
    String name = delivery.channel.sourceOf(delivery.message);
    if (delivery.channel.deliversEvery() && name.isEmpty()) {
      return;
    }
    KnownSources<Delivery> known = sourcesOf(delivery.channel);
    KnownSources.Source<Delivery> source = known.heard(name);
    source = source == null ? known.add(name) : source;
    if (!name.isEmpty()) {
      known.takes(source, delivery.message.receivedBytes());
    }
    if (!delivery.channel.deliversEvery()) {
      waits(delivery, source);
    }
  }

  public synchronized int depth() {
    return urgent.size() + queue.size();
  }

  /** Messages lost so far. */
  public synchronized long dropped() {
    return dropped;
  }

  /** Messages superseded by newer ones of the same source before being handled. */
  public synchronized long replaced() {
    return replaced;
  }
}
