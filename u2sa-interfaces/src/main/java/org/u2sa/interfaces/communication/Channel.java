package org.u2sa.interfaces.communication;

import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
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
  private final Function<? super T, String> source;
  private final Set<Trait> traits;

  // Of type, traits and name; each is asked for several times a message.
  private final Class<T> messageClass;
  private final boolean deliversEvery;
  private final boolean retained;
  private final boolean urgent;
  private final boolean reservesRoom;
  private final int hash;

  private enum Trait {
    EVERY,
    RETAINED,
    BY_SOURCE, // if retained
    URGENT,
    RESERVED
  }

  private Channel(
      String name,
      MessageType<T> type,
      CarriedTypes carried,
      Function<? super T, String> source,
      Set<Trait> traits) {
    this.name = name;
    this.type = type;
    this.carried = carried;
    this.source = source;
    this.traits = traits;
    messageClass = type.messageClass();
    deliversEvery = traits.contains(Trait.EVERY);
    retained = traits.contains(Trait.RETAINED);
    urgent = traits.contains(Trait.URGENT);
    reservesRoom = urgent || traits.contains(Trait.RESERVED);
    hash = name.hashCode();
  }

  private static <T extends U2SAData> Channel<T> of(
      String name, MessageType<T> type, Function<? super T, String> source, Set<Trait> traits) {
    if (!isName(name)) {
      throw new IllegalArgumentException(
          "channel \""
              + name
              + "\": expected lower-case words joined by hyphens, such as \"goal-reports\"");
    }
    Objects.requireNonNull(type, "type");
    return new Channel<>(name, type, CarriedTypes.by(type), source, traits);
  }

  private Channel<T> with(Trait first, Trait... others) {
    Set<Trait> all = EnumSet.of(first, others);
    all.addAll(traits);
    return new Channel<>(name, type, carried, source, all);
  }

  /**
   * A channel on which each message matters, such as commands and reports: a subscriber gets all of
   * them, in order, as far as its inbox holds.
   *
   * @param name lower-case words joined by hyphens, for example {@code goal-reports}
   * @throws IllegalArgumentException if the name is not of that form
   */
  public static <T extends U2SAData> Channel<T> every(String name, MessageType<T> type) {
    return every(name, type, message -> "");
  }

  /**
   * {@link #every(String, MessageType)} with sources that are told apart: a subscriber keeps
   * something for each.
   *
   * @param source what tells the sources on the channel apart, for example the sensor's name
   * @throws IllegalArgumentException if the name is not of that form
   */
  public static <T extends U2SAData> Channel<T> every(
      String name, MessageType<T> type, Function<? super T, String> source) {
    return of(name, type, source, EnumSet.of(Trait.EVERY));
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
    return of(name, type, source, EnumSet.noneOf(Trait.class));
  }

  /**
   * This channel, but of the subclasses of its type it carries these and their subclasses only: a
   * channel of requests and answers has several types, and nothing else may travel on it.
   */
  @SafeVarargs
  public final Channel<T> carrying(MessageType<? extends T>... types) {
    return new Channel<>(name, type, CarriedTypes.only(types), source, traits);
  }

  /** This channel, but late subscribers receive the last message of each source at once. */
  public Channel<T> retained() {
    return with(Trait.RETAINED);
  }

  /**
   * {@link #retained()} where there are several sources: the broker holds the last message of each,
   * under a topic that ends with its name.
   */
  public Channel<T> retainedBySource() {
    return with(Trait.RETAINED, Trait.BY_SOURCE);
  }

  /**
   * This channel, but its messages overtake all others that wait for a service. Of use only where
   * each message matters.
   */
  public Channel<T> urgent() {
    return with(Trait.URGENT);
  }

  /**
   * This channel, but its messages find room in a service's inbox when the others have filled
   * theirs; they wait in their order all the same.
   */
  public Channel<T> reservingRoom() {
    return with(Trait.RESERVED);
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
    return deliversEvery;
  }

  /** Whether a late subscriber is handed the last message of each source. */
  public boolean isRetained() {
    return retained;
  }

  /** Whether its messages find room where others have filled theirs. */
  public boolean reservesRoom() {
    return reservesRoom;
  }

  /** Whether a topic of the channel may end with its source. */
  public boolean isRetainedBySource() {
    return traits.contains(Trait.BY_SOURCE);
  }

  /** Whether its messages overtake others that wait for a service. */
  public boolean isUrgent() {
    return urgent;
  }

  /** Which source the message is of; newer messages of one source replace older ones. */
  public String sourceOf(U2SAData message) {
    return messageClass.isInstance(message) ? source.apply(messageClass.cast(message)) : "";
  }

  /**
   * Whether the message may travel on this channel: it is of the channel's type or a subclass, and
   * of one that the channel carries. A channel of any message carries none of the service contract:
   * those have channels of their own.
   */
  public boolean carries(U2SAData message) {
    return messageClass.isInstance(message) && (carried == null || carried.include(message.type()));
  }

  /** {@link #carries(U2SAData)} of a message of that type. */
  public boolean carries(MessageType<?> other) {
    return messageClass.isAssignableFrom(other.messageClass())
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

  @Override
  public boolean equals(Object other) {
    return this == other
        || other instanceof Channel<?> channel && channel.hash == hash && channel.name.equals(name);
  }

  @Override
  public int hashCode() {
    return hash;
  }

  @Override
  public String toString() {
    return name;
  }

  /**
   * Which subclasses of its type a channel carries.
   *
   * @param types these and their subclasses; empty: all but those of the service contract
   */
  record CarriedTypes(List<MessageType<?>> types) {
    /** Where the service contract's messages are: commands, requests, answers, reports. */
    private static final String CONTRACT = "org.u2sa.messages.contract.";

    static CarriedTypes only(MessageType<?>... types) {
      return new CarriedTypes(List.of(types));
    }

    /**
     * Of a channel of that type, unless it says more. Null if the type alone decides: a channel
     * that names its type, even one of the contract, means it.
     */
    static CarriedTypes by(MessageType<?> type) {
      return type == U2SAData.TYPE ? new CarriedTypes(List.of()) : null;
    }

    boolean include(MessageType<?> other) {
      for (MessageType<?> type = other; type != null; type = type.parent().orElse(null)) {
        if (types.isEmpty() && isOfContract(type)) {
          return false;
        }
        if (types.contains(type)) {
          return true;
        }
      }
      return types.isEmpty();
    }

    /** Whether the type is one of the service contract itself. */
    static boolean isOfContract(MessageType<?> type) {
      return type.messageClass().getName().startsWith(CONTRACT);
    }
  }
}
