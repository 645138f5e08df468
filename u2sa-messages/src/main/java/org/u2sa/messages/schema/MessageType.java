package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A message class's schema: its name, ancestry and fields. Immutable; one instance a class, {@code
 * public static final TYPE}, made by {@link Schema}.
 *
 * @param <T> the message class
 */
public final class MessageType<T extends U2SAData> {
  /** Who the type is. */
  record Identity<T extends U2SAData>(
      String name,
      Class<T> messageClass,
      Supplier<? extends T> empty,
      boolean isAbstract,
      MessageType<? super T> parent) {}

  /** How much storage a message needs, and how many presence bits it has. */
  record Sizes(int numbers, int values, int bits) {}

  private final Identity<T> identity;
  private final List<MessageField<T>> fields;
  private final Map<String, MessageField<T>> byName = new HashMap<>();
  private final Map<String, String> aliases;
  private final ValueField<?, ReferenceFrame> frameField; // null: none
  private final Sizes sizes;
  private final List<String> chain;
  private final List<MessageField<T>> required = new ArrayList<>();
  private final MessageField<T>[] inOrder; // the fields
  private final List<ValueField<T, ?>> values = new ArrayList<>(); // of the fields
  private final long alwaysWritten; // bit n: the number of slot n has a default
  private final NumberField<T>[] numbers; // by slot
  private final int[] numbersBefore; // by index in values: numbers whose slot is below come first
  private final int[] messageLists; // slots of values
  private final long[] beginnings; // of the fields' names, and the bits of them that count
  private final long[] masks;

  MessageType(
      Identity<T> identity,
      List<MessageField<T>> fields,
      Map<String, String> aliases,
      ValueField<?, ReferenceFrame> frameField,
      Sizes sizes) {
    this.identity = identity;
    this.fields = fields;
    this.aliases = aliases;
    this.frameField = frameField;
    this.sizes = sizes;
    inOrder = array(fields);
    numbers = numberArray(sizes.numbers());
    beginnings = new long[inOrder.length];
    masks = new long[inOrder.length];
    int[] before = new int[inOrder.length];
    int numbersSoFar = 0;
    long always = 0L;
    for (MessageField<T> field : fields) {
      beginnings[byName.size()] = field.key.beginning();
      masks[byName.size()] = field.key.mask();
      byName.put(field.name(), field);
      if (field instanceof ValueField<T, ?> value) {
        before[values.size()] = numbersSoFar;
        values.add(value);
      } else if (field instanceof NumberField<T> number) {
        numbers[number.slot] = number;
        numbersSoFar = number.slot + 1; // slots are allotted in the fields' order
        always |= Double.isNaN(number.ifUnset) ? 0L : 1L << number.slot;
      }
      if (field.isRequired()) {
        required.add(field);
      }
    }
    messageLists =
        values.stream()
            .filter(field -> field.kind() == Kind.MESSAGE_LIST)
            .mapToInt(field -> field.slot)
            .toArray();
    alwaysWritten = always;
    numbersBefore = before;
    List<String> names = new ArrayList<>();
    if (identity.parent() != null) {
      names.addAll(identity.parent().chain());
      names.add(identity.name());
    }
    chain = List.copyOf(names);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // there are no arrays of generic types
  private static <T extends U2SAData> MessageField<T>[] array(List<MessageField<T>> fields) {
    return fields.toArray(new MessageField[0]);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // likewise
  private static <T extends U2SAData> NumberField<T>[] numberArray(int length) {
    return new NumberField[length];
  }

  /** A field reads and writes every subclass of the class that declares it. */
  @SuppressWarnings(
      "unchecked") // MessageField only ever takes its T, so a parent's field serves the child
  static <T extends U2SAData> MessageField<T> inherited(MessageField<? super T> field) {
    return (MessageField<T>) field;
  }

  /** As in topics and XML: the class's simple name. */
  public String name() {
    return identity.name();
  }

  /** The class. */
  public Class<T> messageClass() {
    return identity.messageClass();
  }

  /** The type of the superclass; empty for {@link U2SAData} alone. */
  public Optional<MessageType<? super T>> parent() {
    return Optional.ofNullable(identity.parent());
  }

  /** True if no message is of this type itself; such as stand for unknown subclasses excepted. */
  public boolean isAbstract() {
    return identity.isAbstract();
  }

  /**
   * Names from the eldest ancestor to this type, U2SAData left out: ["ActuatorCommand",
   * "PercentageCommand"].
   */
  public List<String> chain() {
    return chain;
  }

  /** All fields, inherited ones first; the order of the wire. */
  public List<MessageField<T>> fields() {
    return fields;
  }

  /** A field by its exact name. */
  public Optional<MessageField<T>> field(String name) {
    return Optional.ofNullable(byName.get(name));
  }

  /**
   * A field by the name that XML gives it: its own, its first letter in either case, or one of its
   * aliases.
   */
  public Optional<MessageField<T>> fieldByElementName(String element) {
    String name =
        element.isEmpty()
            ? element
            : element.substring(0, 1).toLowerCase(Locale.ROOT) + element.substring(1);
    Optional<MessageField<T>> exact = field(name);
    return exact.isPresent() || !aliases.containsKey(name) ? exact : field(aliases.get(name));
  }

  /**
   * A message with nothing set.
   *
   * @throws IllegalStateException if the type is abstract
   */
  public T create() {
    if (isAbstract()) {
      throw new IllegalStateException(name() + " is abstract: no message can be of this type");
    }
    return identity.empty().get();
  }

  /**
   * A message to decode or copy into: of this type, or a stand-in if it is abstract.
   *
   * @throws IllegalStateException for U2SAData, of which there is none
   */
  T newCarrier() {
    if (identity.empty() == null) {
      throw new IllegalStateException("no message can be of type " + name());
    }
    return identity.empty().get();
  }

  /**
   * Reads a key if it is a field's, written as short as can be.
   *
   * @param from index of the field to begin with: that after the one before, as writers keep the
   *     order
   * @return the field's index; -1 if the key is none of those, or is before that one
   */
  int takeKey(CborInput in, int from) {
    long word = in.word();
    for (int index = from; index < inOrder.length; index++) {
      if ((word & masks[index]) == beginnings[index] && in.take(inOrder[index].key)) {
        return index;
      }
    }
    return -1;
  }

  /** Writes all fields of a message that are to be written, in their order. */
  void write(CborOutput out, T message) {
    FieldStorage storage = message.storage();
    long left = storage.numbersWritten(alwaysWritten);
    for (int i = 0; i < values.size(); i++) {
      left = out.numbers(numbers, storage, left, numbersBefore[i]);
      values.get(i).write(out, message);
    }
    out.numbers(numbers, storage, left, Long.SIZE);
  }

  /** The field of that index in {@link #fields()}. */
  MessageField<T> at(int index) {
    return inOrder[index];
  }

  /** How many fields of a message are on the wire. */
  int written(T message) {
    int count = Long.bitCount(message.storage().numbersWritten(alwaysWritten));
    for (int i = 0; i < values.size(); i++) {
      if (values.get(i).isWritten(message)) {
        count++;
      }
    }
    return count;
  }

  /** Those without which a message is not complete. */
  List<MessageField<T>> requiredFields() {
    return required;
  }

  /** Slots of the values that are lists of messages. */
  int[] messageLists() {
    return messageLists;
  }

  MessageField<T> fieldOrNull(String name) {
    return byName.get(name);
  }

  /** The field that names the frame of the coordinates; null if there is none. */
  ValueField<?, ReferenceFrame> frameField() {
    return frameField;
  }

  Map<String, String> aliases() {
    return aliases;
  }

  Sizes sizes() {
    return sizes;
  }

  /** "ActuatorCommand/PercentageCommand". */
  @Override
  public String toString() {
    return String.join("/", chain);
  }
}
