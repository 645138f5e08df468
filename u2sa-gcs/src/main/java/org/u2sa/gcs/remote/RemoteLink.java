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
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.directory.ClockAgreement;

/** A connection to a running system. Thread-safe. */
public final class RemoteLink implements AutoCloseable {
  private static final long LOOK_MICROS = 20_000;
  private static final double TIME_WITHIN_S = 1.0;
  private static final long TIME_EVERY_MICROS = 30 * Clock.MICROS_PER_SECOND;
  private static final long TOLD_MICROS = Clock.MICROS_PER_SECOND / 2; // smaller changes are not

  private final String systemId;
  private final Clock clock;
  private final double timeoutS;
  private final Consumer<String> trouble;
  private final Map<String, List<Consumer<U2SAData>>> listeners = new ConcurrentHashMap<>();
  private final Connection connection;
  private volatile long aheadMicros; // lead of the system's time over the clock
  private final Thread timeKeeper; // started by keepTime
  private final Thread ending; // also disconnects an interrupted command cleanly

  /**
   * Connects.
   *
   * @param name of the client, for the broker's log
   * @param timeoutS timeout for answers [s]
   * @param trouble receives a line when the connection is lost or restored
   * @throws CommunicationException if the broker cannot be reached
   */
  public RemoteLink(
      Transport transport, String name, Clock clock, double timeoutS, Consumer<String> trouble) {
    systemId = transport.systemId();
    this.clock = clock;
    this.timeoutS = timeoutS;
    this.trouble = trouble;
    connection = transport.connect(name, new Incoming());
    timeKeeper = new Thread(this::askForTime, name + "-time");
    timeKeeper.setDaemon(true);
    ending = new Thread(connection::close, name + "-end");
    Runtime.getRuntime().addShutdownHook(ending);
  }

  /** Returns the ID of the joined system. */
  public String systemId() {
    return systemId;
  }

  /** Returns the timeout of {@link #ask} [s]. */
  public double timeoutS() {
    return timeoutS;
  }

  /** Returns the real-time clock used for waiting and for timestamps. */
  public Clock clock() {
    return clock;
  }

  /**
   * Asks the system for its time, and from now on stamps messages with it: services judge orders by
   * their age. Keeps this computer's time if an answer agrees with it, if nobody answers within a
   * second or, on a slow link, half the timeout, or if the system runs in simulated time.
   */
  public void adoptTime() throws InterruptedException {
    ClockAgreement agreement = new ClockAgreement(clock.micros());
    Consumer<U2SAData> listener =
        message -> {
          if (message instanceof DiscoveryResponse response) {
            agreement.hear(response, clock.micros());
          }
        };
    listen(Channels.DISCOVERY, listener);
    try {
      agreement.asked(clock.micros());
      publish(Channels.DISCOVERY, new DiscoveryRequest());
      await(() -> agreement.isReached(clock.micros()), Math.max(TIME_WITHIN_S, timeoutS / 2.0));
    } finally {
      listenNoMore(Channels.DISCOVERY, listener);
    }
    if (agreement.isHeard()) {
      List<String> said = new ArrayList<>();
      long ahead = agreement.aheadMicros(said::add);
      if (Math.abs(ahead - aheadMicros) > TOLD_MICROS) {
        said.forEach(trouble);
      }
      aheadMicros = ahead;
    }
  }

  /**
   * {@link #adoptTime} now and every half minute, in the background: on a link that lasts, the
   * vehicle may be restarted with another clock. Messages sent before the first answer carry this
   * computer's time, because stops must not wait. Call it once.
   */
  public void keepTime() {
    timeKeeper.start();
  }

  private void askForTime() {
    try (Clock.Waiter waiter = clock.newWaiter("link-time")) {
      while (!timeKeeper.isInterrupted()) {
        try {
          adoptTime();
        } catch (CommunicationException e) {
          trouble.accept("cannot ask for the vehicle's time now: " + e.getMessage());
        }
        long due = clock.micros() + TIME_EVERY_MICROS;
        while (clock.micros() < due) {
          waiter.await(due);
        }
      }
    } catch (InterruptedException e) {
      timeKeeper.interrupt(); // closed
    }
  }

  /**
   * Subscribes the listener to a channel. It is called on the transport's thread and must not
   * block.
   *
   * @throws CommunicationException if the broker refuses the subscription
   */
  @SuppressWarnings("unchecked") // a channel carries only messages of its type
  public <T extends U2SAData> void listen(Channel<T> channel, Consumer<? super T> listener) {
    listeners
        .computeIfAbsent(channel.name(), name -> new CopyOnWriteArrayList<>())
        .add((Consumer<U2SAData>) listener);
    if (!connection.subscribe(channel)) {
      throw new CommunicationException(
          "the broker refuses \"" + channel + "\" of system \"" + systemId + "\"");
    }
  }

  /** Unsubscribes a listener of {@link #listen}. */
  public void listenNoMore(Channel<?> channel, Consumer<?> listener) {
    listeners.getOrDefault(channel.name(), new ArrayList<>()).remove(listener);
  }

  /** Removes all listeners of a channel and unsubscribes from the broker. */
  public void unsubscribe(Channel<?> channel) {
    listeners.remove(channel.name());
    connection.unsubscribe(channel);
  }

  /**
   * Publishes a message; system ID and time are filled in if absent.
   *
   * @throws CommunicationException if the message was not accepted
   */
  public void publish(Channel<?> channel, U2SAData message) {
    if (!message.isFrozen()) {
      if (message.systemId().isEmpty()) {
        message.systemId(systemId);
      }
      if (message.timestamp().isEmpty()) {
        message.timestamp(clock.micros() + aheadMicros);
      }
      message.freeze();
    }
    if (!connection.publish(channel, message)) {
      throw new CommunicationException(
          "the broker did not accept a message on \"" + channel + "\": is the connection lost?");
    }
  }

  /**
   * Publishes a request and passes on the answers on its channel until {@code enough} holds or
   * {@link #timeoutS} has elapsed.
   *
   * @param request not frozen yet; system and time are filled in
   * @param type of the answers, including subclasses
   * @param answers receives each answer, on the transport's thread
   * @param enough whether to stop waiting; polled every 20 ms
   * @throws CommunicationException if the request was not accepted
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
   * Returns the first answer to a request, like {@link #ask}; empty on timeout.
   *
   * @param isAnswer whether a message is the answer, for example by the request's ID
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
   * Waits until a condition holds, or for a maximum time.
   *
   * @param holds condition, polled every 20 ms; may depend on answers or on which services are
   *     heard
   * @param atMostS maximum wait [s]
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
    timeKeeper.interrupt();
    try {
      Runtime.getRuntime().removeShutdownHook(ending);
    } catch (IllegalStateException e) {
      return; // shutting down: the hook closes the connection
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
