package org.u2sa.interfaces.communication;

import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * A named stream of one message type (thesis 8.2.3.1) and its delivery policy.
 *
 * <p>Subclasses of the type are also carried, and received as themselves or as their nearest known
 * ancestor (thesis 8.2.5). Channels are equal if their names are.
 *
 * @param <T> base message type
 */
public final class Channel<T extends U2SAData> {
  private final String name;
  private final MessageType<T> type;
  private final CarriedTypes carried; // null: the type and all its subclasses
  private final Function<? super T, String> source;
  private final Set<Trait> traits;

  // Derived from type, traits and name; cached because each is used several times per message.
  private final Class<T> messageClass;
  private final boolean deliversEvery;
  private final boolean retained;
  private final boolean urgent;
  private final boolean reservesRoom;
  private final int hash;

  private enum Trait {
    EVERY,
    RETAINED,
    UNDECLARED,
    BY_SOURCE, // only if retained
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
   * Channel on which every message matters, such as commands and reports: a subscriber receives all
   * of them in order, up to the capacity of its inbox.
   *
   * @param name lower-case words joined by hyphens, for example {@code goal-reports}
   * @throws IllegalArgumentException if the name is not of that form
   */
  public static <T extends U2SAData> Channel<T> every(String name, MessageType<T> type) {
    return every(name, type, message -> "");
  }

  /**
   * {@link #every(String, MessageType)} with distinguishable sources, for subscribers that keep
   * state per source.
   *
   * @param source identifies the source of a message, for example by sensor name
   * @throws IllegalArgumentException if the name is not of that form
   */
  public static <T extends U2SAData> Channel<T> every(
      String name, MessageType<T> type, Function<? super T, String> source) {
    return of(name, type, source, EnumSet.of(Trait.EVERY));
  }

  /**
   * Channel on which a newer message replaces an older one of the same source, such as states and
   * held commands: a slow subscriber receives only the newest. Parameters as for {@link #every}.
   */
  public static <T extends U2SAData> Channel<T> latest(
      String name, MessageType<T> type, Function<? super T, String> source) {
    return of(name, type, source, EnumSet.noneOf(Trait.class));
  }

  /**
   * Copy that carries only these subclasses of its type, and their subclasses, for request/response
   * channels with several types.
   */
  @SafeVarargs
  public final Channel<T> carrying(MessageType<? extends T>... types) {
    return new Channel<>(name, type, CarriedTypes.only(types), source, traits);
  }

  /** Copy on which late subscribers immediately receive the last message (retained). */
  public Channel<T> retained() {
    return with(Trait.RETAINED);
  }

  /**
   * Channel known by its name only, for readers of a channel that others declare: it carries any
   * data, every message matters, and messages that its publisher retained are accepted.
   */
  static Channel<U2SAData> undeclared(String name) {
    return Channel.every(name, U2SAData.TYPE).with(Trait.UNDECLARED);
  }

  /**
   * {@link #retained()} per source: the broker retains the last message of each, under a topic that
   * ends with its name.
   */
  public Channel<T> retainedBySource() {
    return with(Trait.RETAINED, Trait.BY_SOURCE);
  }

  /** Copy whose messages have priority over all others in a service's inbox. */
  public Channel<T> urgent() {
    return with(Trait.URGENT);
  }

  /** Copy whose messages have reserved space in a service's inbox, in order of arrival. */
  public Channel<T> reservingRoom() {
    return with(Trait.RESERVED);
  }

  public String name() {
    return name;
  }

  public MessageType<T> type() {
    return type;
  }

  /** Whether every message matters; otherwise only the newest of each source. */
  public boolean deliversEvery() {
    return deliversEvery;
  }

  /** Whether late subscribers receive the last message of each source. */
  public boolean isRetained() {
    return retained;
  }

  /** Whether a message published before the subscription is accepted. */
  public boolean acceptsRetained() {
    return retained || traits.contains(Trait.UNDECLARED);
  }

  /** Whether its messages have reserved inbox space. */
  public boolean reservesRoom() {
    return reservesRoom;
  }

  /** Whether topics of the channel may end with the source. */
  public boolean isRetainedBySource() {
    return traits.contains(Trait.BY_SOURCE);
  }

  /** Whether its messages overtake others in the inbox. */
  public boolean isUrgent() {
    return urgent;
  }

  /** Source of a message; newer messages of a source replace older ones. */
  public String sourceOf(U2SAData message) {
    return messageClass.isInstance(message) ? source.apply(messageClass.cast(message)) : "";
  }

  /**
   * Whether the message's type is the channel's or a permitted subclass. A channel of any message
   * carries none of the service contract's types.
   */
  public boolean carries(U2SAData message) {
    return messageClass.isInstance(message) && (carried == null || carried.include(message.type()));
  }

  /** {@link #carries(U2SAData)} for a message type. */
  public boolean carries(MessageType<?> other) {
    return messageClass.isAssignableFrom(other.messageClass())
        && (carried == null || carried.include(other));
  }

  /** Carried types, without their subclasses. */
  public List<MessageType<?>> carriedTypes() {
    return carried == null || carried.types().isEmpty() ? List.of(type) : carried.types();
  }

  static boolean isName(String name) {
    // By hand: topics come from strangers, and a pattern takes stack for each word.
    char before = '-';
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      boolean isLetter = c >= 'a' && c <= 'z';
      boolean isDigit = c >= '0' && c <= '9' && i > 0;
      if (!isLetter && !isDigit && (c != '-' || before == '-')) {
        return false;
      }
      before = c;
    }
    return before != '-';
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

  /** Subclasses that a channel carries; empty: all except those of the service contract. */
  record CarriedTypes(List<MessageType<?>> types) {
    /** Packages of the service contract's messages: commands, requests, responses, reports. */
    private static final List<String> CONTRACT =
        List.of(
            "org.u2sa.messages.contract.",
            "org.u2sa.messages.mission.",
            "org.u2sa.messages.safety.");

    static CarriedTypes only(MessageType<?>... types) {
      return new CarriedTypes(List.of(types));
    }

    /** Default for a channel of this type; null if the type alone decides. */
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

    static boolean isOfContract(MessageType<?> type) {
      String name = type.messageClass().getName();
      return CONTRACT.stream().anyMatch(name::startsWith);
    }
  }
}
