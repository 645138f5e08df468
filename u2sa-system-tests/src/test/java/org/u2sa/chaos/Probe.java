package org.u2sa.chaos;

import java.util.BitSet;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/**
 * A sender and a receiver that number what they exchange over the broken network: what does not
 * arrive must be counted by the receiver.
 */
final class Probe implements AutoCloseable {
  private static final Channel<GoalCommand> CHANNEL =
      Channel.every("chaos-probe", GoalCommand.TYPE);
  private static final long EVERY_MICROS = 20_000;

  private final Clock clock;
  private final Connection sender;
  private final Connection receiver;
  private final AtomicLong sent = new AtomicLong();
  private final BitSet arrived = new BitSet(); // under its own lock
  private final Thread thread = new Thread(this::send, "probe-sender");

  Probe(int brokerPort, Clock clock) {
    this.clock = clock;
    MessageCodec codec = new MessageCodec(MessageTypes.discovered());
    MqttTransport transport = new MqttTransport("127.0.0.1", brokerPort, "cessna", codec);
    receiver = transport.connect("ProbeReceiver", new Arrivals());
    receiver.subscribe(CHANNEL);
    sender = transport.connect("ProbeSender", new Arrivals());
    thread.setDaemon(true);
    thread.start();
  }

  private void send() {
    try (Clock.Waiter waiter = clock.newWaiter("probe-sender")) {
      while (!Thread.currentThread().isInterrupted()) {
        send(sent.incrementAndGet());
        waiter.await(clock.micros() + EVERY_MICROS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void send(long number) {
    GoalCommand command = new GoalCommand().uid(String.valueOf(number));
    command.freeze();
    sender.publish(CHANNEL, command); // whether it was taken or not, its number is used up
  }

  /** Ends the sending and sends until one arrives, so that a gap at the end is seen too. */
  void finish() throws InterruptedException {
    thread.interrupt();
    thread.join();
    try (Clock.Waiter waiter = clock.newWaiter("probe-finish")) {
      long deadline = clock.micros() + Clock.micros(30.0);
      long last;
      do {
        last = sent.incrementAndGet();
        send(last);
        waiter.await(clock.micros() + Clock.micros(0.5));
      } while (!hasArrived(last) && clock.micros() < deadline);
    }
  }

  private boolean hasArrived(long number) {
    synchronized (arrived) {
      return arrived.get((int) number);
    }
  }

  long sent() {
    return sent.get();
  }

  /** Different messages that came. */
  long received() {
    synchronized (arrived) {
      return arrived.cardinality();
    }
  }

  /** Messages that the receiver's connection knows it missed. */
  long missed() {
    return receiver.missed();
  }

  @Override
  public void close() {
    sender.close();
    receiver.close();
  }

  /** Ticks off what comes. */
  private final class Arrivals implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      synchronized (arrived) {
        arrived.set(Integer.parseInt(((GoalCommand) message).uid()));
      }
    }

    @Override
    public void trouble(String what) {
      // expected throughout: what counts is the sum at the end
    }
  }
}
