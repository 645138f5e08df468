package org.u2sa.service.handover;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/**
 * State of a service that is transferred to its successor or restored after a restart: named
 * values, so that independent algorithms can share those that both understand. The old service
 * writes it in {@code handOver}, the new one reads it in {@code takeOver}. Not thread-safe.
 */
public final class HandOver {
  private static final String SAVED = "SAVED";
  private static final double FRESH_S = 1.0;

  private final String className;
  private final Map<String, Object> values = new LinkedHashMap<>();

  /**
   * @param className class of the predecessor
   */
  public HandOver(String className) {
    this.className = className;
  }

  /** Class of the predecessor; class-specific values are meaningless to other classes. */
  public String className() {
    return className;
  }

  /** Notes when it is saved [s of the run's clock]. */
  public HandOver savedAt(double nowS) {
    return number(SAVED, nowS);
  }

  /**
   * Whether it was saved within the last second, as in a swap. Otherwise it was {@linkplain
   * org.u2sa.service.U2SAService#remember remembered} before a restart: what changes quickly, such
   * as an integrator, is out of date.
   */
  public boolean isFresh(double nowS) {
    return ageS(nowS) <= FRESH_S;
  }

  /** Time since it was saved [s]; 0 if unknown. */
  public double ageS(double nowS) {
    return nowS - number(SAVED).orElse(nowS);
  }

  public Set<String> names() {
    return Set.copyOf(values.keySet());
  }

  /** All values by name: Strings, Doubles, Booleans, messages, and Lists of texts or messages. */
  Map<String, Object> values() {
    return Collections.unmodifiableMap(values);
  }

  public HandOver text(String name, String value) {
    return set(name, value);
  }

  /**
   * @throws IllegalArgumentException if the value is not a text
   */
  public Optional<String> text(String name) {
    return get(name, String.class, "text");
  }

  /** Sets a number, in SI units; NaN is omitted. */
  public HandOver number(String name, double value) {
    return Double.isNaN(value) ? this : set(name, value);
  }

  /**
   * @throws IllegalArgumentException if the value is not a number
   */
  public OptionalDouble number(String name) {
    Optional<Double> value = get(name, Double.class, "number");
    return value.isPresent() ? OptionalDouble.of(value.get()) : OptionalDouble.empty();
  }

  public HandOver flag(String name, boolean value) {
    return set(name, value);
  }

  /**
   * False if absent.
   *
   * @throws IllegalArgumentException if the value is not a flag
   */
  public boolean flag(String name) {
    return get(name, Boolean.class, "flag").orElse(false);
  }

  public HandOver texts(String name, Iterable<String> value) {
    return set(name, list(value));
  }

  /**
   * @throws IllegalArgumentException if the value is not a list of texts
   */
  public List<String> texts(String name) {
    return members(name, String.class, "list of texts");
  }

  /** Sets a message; an unfrozen one is copied. */
  public HandOver message(String name, U2SAData value) {
    return set(name, frozen(value));
  }

  /**
   * @throws IllegalArgumentException if the value is not a message of that class
   */
  public <T extends U2SAData> Optional<T> message(String name, Class<T> type) {
    return get(name, type, type.getSimpleName());
  }

  public HandOver messages(String name, Iterable<? extends U2SAData> value) {
    List<U2SAData> messages = new ArrayList<>();
    value.forEach(message -> messages.add(frozen(message)));
    return set(name, List.copyOf(messages));
  }

  /**
   * Empty if absent.
   *
   * @throws IllegalArgumentException if the value is not a list of messages of that class
   */
  public <T extends U2SAData> List<T> messages(String name, Class<T> type) {
    return members(name, type, "list of " + type.getSimpleName());
  }

  private static U2SAData frozen(U2SAData message) {
    if (message.isFrozen()) {
      return message;
    }
    U2SAData copy = message.copy();
    copy.freeze();
    return copy;
  }

  private static List<String> list(Iterable<String> texts) {
    List<String> list = new ArrayList<>();
    texts.forEach(list::add);
    return List.copyOf(list);
  }

  private HandOver set(String name, Object value) {
    if (values.put(name, value) != null) {
      throw new IllegalArgumentException("value \"" + name + "\" is handed over twice");
    }
    return this;
  }

  private <T> Optional<T> get(String name, Class<T> type, String expected) {
    Object value = values.get(name);
    if (value != null && !type.isInstance(value)) {
      throw wrongKind(name, value, expected);
    }
    return Optional.ofNullable(type.cast(value));
  }

  private <T> List<T> members(String name, Class<T> type, String expected) {
    List<T> members = new ArrayList<>();
    for (Object member : get(name, List.class, expected).orElse(List.of())) {
      if (!type.isInstance(member)) {
        throw wrongKind(name, member, expected);
      }
      members.add(type.cast(member));
    }
    return members;
  }

  private IllegalArgumentException wrongKind(String name, Object value, String expected) {
    return new IllegalArgumentException(
        "value \"" + name + "\" of " + className + " is " + value + ", expected " + expected);
  }

  @Override
  public String toString() {
    return className + values;
  }
}
