package org.u2sa.core.communication;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.core.communication.routing.RemoteInterest;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.OriginNumbers;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.Origin;
import org.u2sa.messages.schema.U2SAData;

/**
 * Sends copies of local messages to remote subscribers. Encoding and sending run on a dedicated
 * thread behind a bounded queue, so that no service blocks on the network; overflow is dropped and
 * counted.
 */
final class OutgoingCopies implements LocalBus.Bridge, AutoCloseable {
  private static final int WAITING_AT_MOST = 8_192;

  /** Maximum number of copies waiting for the network's thread. */
  private static final int ON_THE_WAY_AT_MOST = 512;

  private static final long LAST_WORDS_WITHIN_MS = 2_000;
  private static final long LOST_AFTER_MS = 1_000;
  private static final long LOOK_UP_EVERY_MS = 100; // poll interval for shutdown

  private record Copy(Channel<?> channel, String topic, U2SAData message, Origin origin) {}

  private final String systemId;
  private final MessageCodec codec;
  private final RemoteInterest interest;
  private final BrokerState broker;
  private final Consumer<String> log;
  private final OriginNumbers numbers = OriginNumbers.ofNewSender();
  private final BlockingQueue<Copy> waiting = new ArrayBlockingQueue<>(WAITING_AT_MOST);
  private Semaphore onTheWay = new Semaphore(ON_THE_WAY_AT_MOST); // used by the sender only
  private final AtomicLong dropped = new AtomicLong();
  private final Thread sender = new Thread(this::send, "u2sa-outgoing-copies");
  private volatile boolean closing;

  /** Creates a sender of one system's messages to a broker's clients. */
  OutgoingCopies(String systemId, MessageCodec codec, BrokerState broker, Consumer<String> log) {
    this.systemId = systemId;
    this.codec = codec;
    interest = new RemoteInterest(systemId, broker.subscriptions, numbers);
    this.broker = broker;
    this.log = log;
    sender.setDaemon(true);
  }

  void start() {
    sender.start();
  }

  @Override
  public void forward(Channel<?> channel, U2SAData message) {
    broker.sources.hearLocal(channel, message);
    if (channel.isRetained()) { // also for late subscribers
      String topic = Topic.of(systemId, channel, message).toString();
      number(numbers.on(topic), channel, topic, message, true);
    } else {
      RemoteInterest.Destination to = interest.destination(channel, message.typeChain());
      number(to.stream(), channel, to.topic(), message, to.isWanted());
    }
  }

  /**
   * Sends a message again, because the broker may have received a local message after the remote
   * one.
   */
  @Override
  public void restate(Channel<?> channel, U2SAData message) {
    forward(channel, message);
  }

  /** Numbers every message, so that a reconnecting client knows how many it missed. */
  private void number(
      OriginNumbers.Stream stream,
      Channel<?> channel,
      String topic,
      U2SAData message,
      boolean wanted) {
    boolean taken;
    synchronized (stream) {
      Origin origin = stream.next();
      taken = !wanted || waiting.offer(new Copy(channel, topic, message, origin));
    }
    if (!taken) {
      drop("the broker is too slow");
    }
  }

  private void send() {
    try {
      // Drains the queue after close, because it may hold the actuators' neutral commands.
      for (Copy copy = next(); copy != null; copy = next()) {
        send(copy);
      }
      onTheWay.tryAcquire(ON_THE_WAY_AT_MOST, LOST_AFTER_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      log.accept("interrupted: " + waiting.size() + " copies for remote subscribers were dropped");
    }
  }

  /** The next copy to send; null if the queue is empty and closed. */
  private Copy next() throws InterruptedException {
    Copy copy = null;
    while (copy == null && !(closing && waiting.isEmpty())) {
      copy = waiting.poll(LOOK_UP_EVERY_MS, TimeUnit.MILLISECONDS);
    }
    return copy;
  }

  private void send(Copy copy) throws InterruptedException {
    if (!onTheWay.tryAcquire(LOST_AFTER_MS, TimeUnit.MILLISECONDS)) {
      // Do not wait for a network thread that has ended: it never completes the send.
      onTheWay = new Semaphore(ON_THE_WAY_AT_MOST);
      onTheWay.acquire();
    }
    Semaphore place = onTheWay;
    try {
      publish(copy, place::release);
    } catch (RuntimeException | OutOfMemoryError e) { // skip only this message
      place.release();
      drop("publishing on \"" + copy.topic + "\" failed: " + e.getMessage());
    }
  }

  private void publish(Copy copy, Runnable sent) {
    boolean eachMatters =
        copy.channel.deliversEvery()
            || copy.channel.isRetained()
            || closing; // request acknowledgement of the final messages
    byte[] payload = codec.encode(copy.message, copy.origin);
    if (eachMatters) {
      broker.keep(payload.length);
    }
    broker.router.send(copy.topic, eachMatters, copy.channel.isRetained(), payload, sent);
  }

  private void drop(String why) {
    long count = dropped.incrementAndGet();
    if (Long.bitCount(count) == 1) { // log the 1st, 2nd, 4th, 8th… to bound the log
      log.accept("a copy for remote subscribers was dropped, " + why + " (" + count + " so far)");
    }
  }

  long dropped() {
    return dropped.get();
  }

  @Override
  public void close() {
    closing = true;
    try {
      sender.join(LAST_WORDS_WITHIN_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    int left = waiting.size();
    if (left > 0) {
      dropped.addAndGet(left);
      log.accept(left + " copies for remote subscribers could not be sent before the end");
    }
  }
}
