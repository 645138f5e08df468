package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;

/** The message types that a reader knows. Immutable. */
public final class MessageTypes {
  private static final int MAX_FAULTS = 100; // of extensions

  private final LinkedHashMap<String, MessageType<?>> byName; // never modified

  private MessageTypes(LinkedHashMap<String, MessageType<?>> byName) {
    this.byName = byName;
  }

  /**
   * Creates a set of the given types.
   *
   * @throws IllegalArgumentException if two types have the same name
   */
  public static MessageTypes of(Collection<? extends MessageType<?>> types) {
    return new MessageTypes(new LinkedHashMap<>()).with(types);
  }

  /** The types of every {@link MessageTypeProvider} on the class path, the standard ones first. */
  public static MessageTypes discovered() {
    List<MessageType<?>> extensions = new ArrayList<>();
    for (MessageTypeProvider provider : ServiceLoader.load(MessageTypeProvider.class)) {
      extensions.addAll(provider.messageTypes());
    }
    return of(extensions);
  }

  /**
   * Those of {@link #discovered()} that can be loaded, for programs that must not fail because of
   * an extension, whatever it throws, such as one that stops a vehicle.
   *
   * @param missing receives why the types of an extension are missing
   */
  public static MessageTypes loadable(Consumer<String> missing) {
    Iterator<MessageTypeProvider> providers =
        ServiceLoader.load(MessageTypeProvider.class).iterator();
    MessageTypes types = of(Collections.emptyList());
    boolean isMore = true;
    for (int faults = 0; isMore && faults < MAX_FAULTS; ) {
      String who = "an extension";
      try {
        isMore = providers.hasNext();
        if (isMore) {
          MessageTypeProvider provider = providers.next();
          who = provider.getClass().getName();
          types = types.with(provider.messageTypes());
        }
      } catch (Exception | Error e) { // whatever the extension's code throws
        faults++;
        String why = e instanceof ServiceConfigurationError ? e.getMessage() : e.toString();
        missing.accept("message types of " + who + " are missing: " + why);
      }
    }
    return types;
  }

  /**
   * These types and more.
   *
   * @throws IllegalArgumentException if two types have the same name
   */
  public MessageTypes with(Collection<? extends MessageType<?>> more) {
    LinkedHashMap<String, MessageType<?>> all = new LinkedHashMap<>(byName);
    for (MessageType<?> type : more) {
      MessageType<?> other = all.put(type.name(), type);
      if (other != null && other != type) {
        throw new IllegalArgumentException(
            String.format(
                "two message types are called %s: %s and %s",
                type.name(), other.messageClass().getName(), type.messageClass().getName()));
      }
    }
    return new MessageTypes(all);
  }

  /** All, in order of registration. */
  public Collection<MessageType<?>> all() {
    return Collections.unmodifiableCollection(byName.values());
  }

  /** A type by its exact name. */
  public Optional<MessageType<?>> byName(String name) {
    return Optional.ofNullable(byName.get(name));
  }

  /**
   * A type by the name of its XML element, whose first letter may be of either case: "waypoint",
   * "Circle".
   */
  public Optional<MessageType<?>> byElementName(String element) {
    if (element.isEmpty()) {
      return Optional.empty();
    }
    return byName(element.substring(0, 1).toUpperCase(Locale.ROOT) + element.substring(1));
  }

  /**
   * The nearest known type in the chain, including the type itself (8.2.5). It may be abstract: the
   * codec then creates a placeholder for the unknown subclass. {@link OpaqueMessage#TYPE} if none
   * is known.
   *
   * <p>The chain up to the known type must equal that type's own chain, so that filters on the
   * first names and the decoder, which uses the last, agree on the type.
   *
   * @throws MalformedMessageException if the chain is empty or too long, or contradicts the
   *     ancestry of a known type
   */
  public MessageType<?> nearest(List<String> chain) throws MalformedMessageException {
    return nearest(chain, 0L);
  }

  MessageType<?> nearest(List<String> chain, long offset) throws MalformedMessageException {
    int size = chain.size();
    if (size == 0 || size > Limits.DEPTH) {
      throw new MalformedMessageException(
          "type chain", offset, "expected 1…" + Limits.DEPTH + " type names, not " + size);
    }
    MessageType<?> known = byName.get(chain.get(size - 1));
    return known != null && known.chain() == chain // fast path: a type of this process
        ? known
        : nearest(chain, size, offset);
  }

  private MessageType<?> nearest(List<String> chain, int size, long offset)
      throws MalformedMessageException {
    for (int length = size; length > 0; length--) {
      MessageType<?> known = byName.get(chain.get(length - 1));
      if (known != null) {
        List<String> claimed = chain.subList(0, length);
        if (!claimed.equals(known.chain())) {
          throw new MalformedMessageException(
              "type chain", offset, "expected " + known + ", not " + String.join("/", claimed));
        }
        return known;
      }
    }
    return OpaqueMessage.TYPE;
  }
}
