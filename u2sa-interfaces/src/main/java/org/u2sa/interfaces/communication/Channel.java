package org.u2sa.interfaces.communication;

import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * A named stream of one type of message (thesis 8.2.3.1) and how it is delivered.
 *
 * <p>Subclasses of the type travel on the channel too and are received as what they are, or as
 * their nearest known ancestor (thesis 8.2.5). Two channels are equal if their names are.
 *
 * @param <T> what the channel carries
 */
public final class Channel<T extends U2SAData> {
  private static final Pattern NAME = Pattern.compile("[a-z][a-z0-9]*(-[a-z0-9]+)*");

  private final String name;
  private final MessageType<T> type;
  private final CarriedTypes carried; // null: the type and its subclasses, whatever they are
  private final boolean every;
  private final boolean retained;
  private final boolean urgent;
  private final boolean bySource; // if retained
  private final boolean reserved;
  private final Function<? super T, String> source;

  private Channel(
      String name,
      MessageType<T> type,
      CarriedTypes carried,
      boolean every,
      boolean retained,
      boolean urgent,
      boolean bySource,
      boolean reserved,
      Function<? super T, String> source) {
    this.name = name;
    this.type = type;
    this.carried = carried;
    this.every = every;
    this.retained = retained;
    this.urgent = urgent;
    this.bySource = bySource;
    this.reserved = reserved;
    this.source = source;
  }

  /**
   * A channel on which each message matters, such as commands and reports: a subscriber gets all of
   * them, in order, as far as its inbox holds.
   *
   * @param name lower-case words joined by hyphens, for example {@code goal-reports}
   * @throws IllegalArgumentException if the name is not of that form
   */
  public static <T extends U2SAData> Channel<T> every(String name, MessageType<T> type) {
    return new Channel<>(
        checked(name),
        Objects.requireNonNull(type, "type"),
        CarriedTypes.by(type),
        true,
        false,
        false,
        false,
        false,
        message -> "");
  }

  /**
   * A channel on which a newer message replaces an older one of the same source, such as states and
   * commands to hold: a subscriber that is late gets the newest only.
   *
   * @param name lower-case words joined by hyphens, for example {@code sensed-state}
   * @param source what tells the sources on the channel apart, for example the sensor's name
   * @throws IllegalArgumentException if the name is not of that form
   */
  public static <T extends U2SAData> Channel<T> latest(
      String name, MessageType<T> type, Function<? super T, String> source) {
    return new Channel<>(
        checked(name),
        Objects.requireNonNull(type, "type"),
        CarriedTypes.by(type),
        false,
        false,
        false,
        false,
        false,
        source);
  }

  /**
   * This channel, but of the subclasses of its type it carries these and their subclasses only: a
   * channel of requests and answers has several types, and nothing else may travel on it.
   */
  @SafeVarargs
  public final Channel<T> carrying(MessageType<? extends T>... types) {
    return new Channel<>(
        name, type, CarriedTypes.only(types), every, retained, urgent, bySource, reserved, source);
  }

  /**
   * This channel, but a subscriber that comes late is handed the last message of each source at
   * once.
   */
  public Channel<T> retained() {
    return new Channel<>(name, type, carried, every, true, urgent, bySource, reserved, source);
  }

  /**
   * {@link #retained()} where there are several sources: the broker holds the last message of each,
   * under a topic that ends with its name.
   */
  public Channel<T> retainedBySource() {
    return new Channel<>(name, type, carried, every, true, urgent, true, reserved, source);
  }

  /**
   * This channel, but its messages overtake all others that wait for a service. Of use only where
   * each message matters.
   */
  public Channel<T> urgent() {
    return new Channel<>(name, type, carried, every, retained, true, bySource, reserved, source);
  }

  /**
   * This channel, but its messages find room in a service's inbox when the others have filled
   * theirs; they wait in their order all the same.
   */
  public Channel<T> reservingRoom() {
    return new Channel<>(name, type, carried, every, retained, urgent, bySource, true, source);
  }

  /** The name that stands in the topic. */
  public String name() {
    return name;
  }

  /** The base type of what the channel carries. */
  public MessageType<T> type() {
    return type;
  }

  /** Whether each message matters; otherwise the newest of each source does. */
  public boolean deliversEvery() {
    return every;
  }

  /** Whether a late subscriber is handed the last message of each source. */
  public boolean isRetained() {
    return retained;
  }

  /** Whether its messages find room where others have filled theirs. */
  public boolean reservesRoom() {
    return reserved || urgent;
  }

  /** Whether a topic of the channel may end with its source. */
  public boolean isRetainedBySource() {
    return bySource;
  }

  /** Whether its messages overtake others that wait for a service. */
  public boolean isUrgent() {
    return urgent;
  }

  /** Which source the message is of; newer messages of one source replace older ones. */
  public String sourceOf(U2SAData message) {
    Class<T> carried = type.messageClass();
    return carried.isInstance(message) ? source.apply(carried.cast(message)) : "";
  }

  /**
   * Whether the message may travel on this channel: it is of the channel's type or a subclass, and
   * of one that the channel carries. A channel of any message carries none of the service contract:
   * those have channels of their own.
   */
  public boolean carries(U2SAData message) {
    return type.messageClass().isInstance(message)
        && (carried == null || carried.include(message.type()));
  }

  /** {@link #carries(U2SAData)} of a message of that type. */
  public boolean carries(MessageType<?> other) {
    return type.messageClass().isAssignableFrom(other.messageClass())
        && (carried == null || carried.include(other));
  }

  /** The types that travel on this channel, their subclasses left out. */
  public List<MessageType<?>> carriedTypes() {
    return carried == null || carried.types().isEmpty() ? List.of(type) : carried.types();
  }

  /** Whether a channel may be called so. */
  static boolean isName(String name) {
    return NAME.matcher(name).matches();
  }

  private static String checked(String name) {
    if (!isName(name)) {
      throw new IllegalArgumentException(
          "channel \""
              + name
              + "\": expected lower-case words joined by hyphens, such as \"goal-reports\"");
    }
    return name;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Channel<?> channel && channel.name.equals(name);
  }

  @Override
  public int hashCode() {
    return name.hashCode();
  }

  @Override
  public String toString() {
    return name;
  }
}
