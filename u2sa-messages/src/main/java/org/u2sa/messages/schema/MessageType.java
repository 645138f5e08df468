package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A message class's schema: its name, ancestry and fields. Immutable; one instance per class,
 * {@code public static final TYPE}, built by {@link Schema}.
 *
 * @param <T> the message class
 */
public final class MessageType<T extends U2SAData> {
  /** Identity of the type. */
  record Identity<T extends U2SAData>(
      String name,
      Class<T> messageClass,
      Supplier<? extends T> empty,
      boolean isAbstract,
      MessageType<? super T> parent) {}

  private final Identity<T> identity;
  private final List<MessageField<T>> fields;
  private final Map<String, MessageField<T>> byName = new HashMap<>();
  final Map<String, String> aliases;
  final Map<MessageField<?>, MessageType<?>> elements; // element types of lists of messages
  final ValueField<?, ReferenceFrame> frameField; // null: none
  final NumberField<?> latitudeField; // in GLOBAL; null: none
  final int[] points; // slots of values
  final int[] pointLists; // slots of values
  final FieldSlots.Sizes sizes;
  private final List<String> chain;
  private final FieldTable<T> names;
  private volatile FieldTable<T> labels; // created lazily: most processes never need it
  final int[] messageLists; // slots of values

  MessageType(
      Identity<T> identity,
      List<MessageField<T>> fields,
      Map<String, String> aliases,
      Map<MessageField<?>, MessageType<?>> elements,
      ValueField<?, ReferenceFrame> frameField,
      FieldSlots.Sizes sizes) {
    this.identity = identity;
    this.fields = fields;
    this.aliases = aliases;
    this.elements = elements;
    this.frameField = frameField;
    this.sizes = sizes;
    names = new FieldTable<>(fields, WireForm.READABLE);
    for (MessageField<T> field : fields) {
      byName.put(field.name(), field);
    }
    latitudeField = byName.get("y") instanceof NumberField<T> y ? y : null;
    messageLists = slotsOf(Kind.MESSAGE_LIST);
    points = slotsOf(Kind.POINT);
    pointLists = slotsOf(Kind.POINT_LIST);
    List<String> names = new ArrayList<>();
    if (identity.parent() != null) {
      names.addAll(identity.parent().chain());
      names.add(identity.name());
    }
    chain = List.copyOf(names);
  }

  private int[] slotsOf(Kind kind) {
    return fields.stream()
        .filter(field -> field.kind() == kind)
        .mapToInt(field -> field.slot)
        .toArray();
  }

  /** Fields apply to all subclasses of the declaring class. */
  @SuppressWarnings(
      "unchecked") // MessageField is contravariant in T, so a parent's field works on the child
  static <T extends U2SAData> MessageField<T> inherited(MessageField<? super T> field) {
    return (MessageField<T>) field;
  }

  /** Name in topics and XML: the class's simple name. */
  public String name() {
    return identity.name();
  }

  /** The class. */
  public Class<T> messageClass() {
    return identity.messageClass();
  }

  /** Type of the superclass; empty only for {@link U2SAData}. */
  public Optional<MessageType<? super T>> parent() {
    return Optional.ofNullable(identity.parent());
  }

  /** Whether the type is abstract: its only direct instances stand for unknown subclasses. */
  public boolean isAbstract() {
    return identity.isAbstract();
  }

  /**
   * Names from the topmost ancestor to this type, without U2SAData: ["ActuatorCommand",
   * "PercentageCommand"].
   */
  public List<String> chain() {
    return chain;
  }

  /** All fields in wire order, inherited ones first. */
  public List<MessageField<T>> fields() {
    return fields;
  }

  /** A field by its exact name. */
  public Optional<MessageField<T>> field(String name) {
    return Optional.ofNullable(byName.get(name));
  }

  /** A field by its XML name: its own name, with the first letter in either case, or an alias. */
  public Optional<MessageField<T>> fieldByElementName(String element) {
    String name =
        element.isEmpty()
            ? element
            : element.substring(0, 1).toLowerCase(Locale.ROOT) + element.substring(1);
    Optional<MessageField<T>> exact = field(name);
    return exact.isPresent() || !aliases.containsKey(name) ? exact : field(aliases.get(name));
  }

  /** XML name of a field as in examples: its alias, if it has one. */
  public String elementName(MessageField<?> field) {
    return aliases.entrySet().stream()
        .filter(alias -> alias.getValue().equals(field.name()))
        .map(Map.Entry::getKey)
        .findFirst()
        .orElse(field.name());
  }

  /** For a field with a list of messages, their type or its nearest common ancestor. */
  public Optional<MessageType<?>> elementType(MessageField<?> field) {
    return Optional.ofNullable(elements.get(field));
  }

  /**
   * Creates an empty message.
   *
   * @throws IllegalStateException if the type is abstract
   */
  public T create() {
    if (isAbstract()) {
      throw new IllegalStateException(name() + " is abstract: no message can have this type");
    }
    return identity.empty().get();
  }

  /**
   * Creates a message to decode or copy into: of this type, or a placeholder if it is abstract.
   *
   * @throws IllegalStateException for U2SAData, which has no instances
   */
  T newCarrier() {
    if (identity.empty() == null) {
      throw new IllegalStateException("no message can have type " + name());
    }
    return identity.empty().get();
  }

  /** Field table with names as keys. */
  FieldTable<T> table() {
    return names;
  }

  /** Field table with keys of the given form. */
  FieldTable<T> table(WireForm form) {
    if (form == WireForm.READABLE) {
      return names;
    }
    FieldTable<T> made = labels;
    if (made == null) { // benign race: both threads create equal tables
      made = new FieldTable<>(fields, WireForm.COMPACT);
      labels = made;
    }
    return made;
  }

  MessageField<T> fieldOrNull(String name) {
    return byName.get(name);
  }

  /** "ActuatorCommand/PercentageCommand". */
  @Override
  public String toString() {
    return String.join("/", chain);
  }
}
