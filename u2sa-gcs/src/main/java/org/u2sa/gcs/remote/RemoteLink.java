package org.u2sa.gcs.remote;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/**
 * A command's connection to a running system. Made by {@link RemoteSystem#connect}; safe for
 * several threads.
 */
public final class RemoteLink implements AutoCloseable {
  private static final long LOOK_MICROS = 20_000;

  private final String systemId;
  private final Clock clock;
  private final double timeoutS;
  private final Consumer<String> trouble;
  private final Map<String, List<Consumer<U2SAData>>> listeners = new ConcurrentHashMap<>();
  private final Connection connection;
  private final Thread ending; // a command that is interrupted takes leave, too: it is not lost

  /**
   * Connects.
   *
   * @param name of who connects, for the broker's log
   * @param timeoutS how long answers are waited for [s]
   * @param trouble takes a line when the connection is lost or restored
   * @throws CommunicationException if the broker cannot be reached
   */
  public RemoteLink(
      Transport transport, String name, Clock clock, double timeoutS, Consumer<String> trouble) {
    systemId = transport.systemId();
    this.clock = clock;
    this.timeoutS = timeoutS;
    this.trouble = trouble;
    connection = transport.connect(name, new Incoming());
    ending = new Thread(connection::close, name + "-end");
    Runtime.getRuntime().addShutdownHook(ending);
  }

  /** The system that was joined. */
  public String systemId() {
    return systemId;
  }

  /** How long {@link #ask} waits at most [s]. */
  public double timeoutS() {
    return timeoutS;
  }

  /** Real time, in which this link waits and dates what it publishes. */
  public Clock clock() {
    return clock;
  }

  /**
   * Calls the listener with each message of the channel from now on, on the transport's thread: it
   * must return at once.
   *
   * @throws CommunicationException if the broker refuses the subscription
   */
  @SuppressWarnings("unchecked") // only messages of the channel's type come in on it
  public <T extends U2SAData> void listen(Channel<T> channel, Consumer<? super T> listener) {
    listeners
        .computeIfAbsent(channel.name(), name -> new CopyOnWriteArrayList<>())
        .add((Consumer<U2SAData>) listener);
    if (!connection.subscribe(channel)) {
      throw new CommunicationException(
          "the broker refuses \"" + channel + "\" of system \"" + systemId + "\"");
    }
  }

  /** Ends {@link #listen} for this listener. */
  public void listenNoMore(Channel<?> channel, Consumer<?> listener) {
    listeners.getOrDefault(channel.name(), new ArrayList<>()).remove(listener);
  }

  /**
   * Publishes; system ID and time are filled in if absent.
   *
   * @throws CommunicationException if the message was not taken
   */
  public void publish(Channel<?> channel, U2SAData message) {
    if (!message.isFrozen()) {
      if (message.systemId().isEmpty()) {
        message.systemId(systemId);
      }
      if (message.timestamp().isEmpty()) {
        message.timestamp(clock.micros());
      }
      message.freeze();
    }
    if (!connection.publish(channel, message)) {
      throw new CommunicationException(
          "the broker did not take a message on \"" + channel + "\": is the connection lost?");
    }
  }

  /**
   * Publishes a request, and hands on the answers that come in on its channel until they are
   * enough, or for {@link #timeoutS}.
   *
   * @param request not frozen yet; system and time are filled in
   * @param type what answers are; subclasses count
   * @param answers takes each answer, on the transport's thread
   * @param enough whether to wait no longer; asked every 20 ms
   * @throws CommunicationException if the request was not taken
   */
  public <T extends U2SAData> void ask(
      Channel<?> channel,
      U2SAData request,
      Class<T> type,
      Consumer<? super T> answers,
      BooleanSupplier enough)
      throws InterruptedException {
    Consumer<U2SAData> listener =
        message -> {
          if (type.isInstance(message)) {
            answers.accept(type.cast(message));
          }
        };
    listen(channel, listener);
    try {
      publish(channel, request);
      await(enough, timeoutS);
    } finally {
      listenNoMore(channel, listener);
    }
  }

  /**
   * The first answer to a request, as {@link #ask}; empty if none comes in time.
   *
   * @param isAnswer tells answers apart, for example by the request's ID
   */
  public <T extends U2SAData> Optional<T> first(
      Channel<?> channel, U2SAData request, Class<T> type, Predicate<? super T> isAnswer)
      throws InterruptedException {
    AtomicReference<T> first = new AtomicReference<>();
    Consumer<T> answers =
        answer -> {
          if (isAnswer.test(answer)) {
            first.compareAndSet(null, answer);
          }
        };
    ask(channel, request, type, answers, () -> first.get() != null);
    return Optional.ofNullable(first.get());
  }

  /**
   * Waits until something holds, at most for a time.
   *
   * @param holds is asked every 20 ms: answers, and who is heard at all, both count
   * @param atMostS how long [s]
   */
  public void await(BooleanSupplier holds, double atMostS) throws InterruptedException {
    long deadline = clock.micros() + Clock.micros(atMostS);
    try (Clock.Waiter waiter = clock.newWaiter("link")) {
      while (!holds.getAsBoolean() && clock.micros() < deadline) {
        waiter.await(Math.min(deadline, clock.micros() + LOOK_MICROS));
      }
    }
  }

  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(ending);
    } catch (IllegalStateException e) {
      return; // the program is ending, and the hook closes the connection
    }
    connection.close();
  }

  /** Called on the transport's thread. */
  private final class Incoming implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      for (Consumer<U2SAData> listener : listeners.getOrDefault(channel.name(), List.of())) {
        listener.accept(message);
      }
    }

    @Override
    public void trouble(String what) {
      trouble.accept(what);
    }
  }
}
