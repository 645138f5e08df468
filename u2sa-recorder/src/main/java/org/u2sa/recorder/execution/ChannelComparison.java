package org.u2sa.recorder.execution;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapException;

/** Compares a service's output on one channel between the recording and the re-execution. */
public final class ChannelComparison {
  private final Channel<?> channel;
  private final UnaryOperator<String> asRecorded;
  private long recorded;
  private long now;
  private long same;
  private Difference first; // null if none
  private final Map<String, NumberComparison> numbers = new LinkedHashMap<>();

  /**
   * The first difference.
   *
   * @param micros time [µs of the run's clock]
   * @param field differing field; its path is empty if a message is missing or surplus
   */
  public record Difference(long micros, FieldDifference field) {}

  ChannelComparison(Channel<?> channel, UnaryOperator<String> asRecorded) {
    this.channel = channel;
    this.asRecorded = asRecorded;
  }

  void add(long micros, RecordedMessage before, U2SAData after) throws McapException {
    recorded += before == null ? 0 : 1;
    now += after == null ? 0 : 1;
    if (before != null && after != null && before.is(after)) {
      same++;
      compare(micros, after, after);
      return;
    }
    U2SAData decoded = before == null ? null : before.decoded();
    Optional<FieldDifference> difference = difference(decoded, after);
    if (difference.isEmpty()) {
      same++;
    } else if (first == null) {
      first = new Difference(micros, difference.get());
    }
    compare(micros, decoded, after);
  }

  /** The difference of messages with other bytes; empty if only temporary paths differ. */
  private Optional<FieldDifference> difference(U2SAData before, U2SAData after) {
    if (before == null) {
      return Optional.of(new FieldDifference("", "no message", after.type().name()));
    }
    if (after == null) {
      return Optional.of(new FieldDifference("", before.type().name(), "no message"));
    }
    return FieldDifference.between(before, after, UnaryOperator.identity()).isEmpty()
        ? Optional.of(new FieldDifference("(encoding)", "other bytes", "other bytes"))
        : FieldDifference.between(before, after, asRecorded);
  }

  /** Compares the numbers that differ in these messages or differed earlier. */
  private void compare(long micros, U2SAData before, U2SAData after) {
    if (first == null) {
      return;
    }
    Map<String, MessageNumbers.At> ofBefore = numbersOf(before);
    Map<String, MessageNumbers.At> ofAfter = numbersOf(after);
    Set<String> names = new LinkedHashSet<>(ofBefore.keySet());
    names.addAll(ofAfter.keySet());
    for (String name : names) {
      MessageNumbers.At a = ofBefore.get(name);
      MessageNumbers.At b = ofAfter.get(name);
      double was = a == null ? Double.NaN : a.value();
      double is = b == null ? Double.NaN : b.value();
      if (was != is || numbers.containsKey(name)) {
        String unit = (a == null ? b : a).unit();
        numbers
            .computeIfAbsent(name, key -> new NumberComparison(name, unit))
            .add(Clock.seconds(micros), was, is);
      }
    }
  }

  private Map<String, MessageNumbers.At> numbersOf(U2SAData message) {
    Map<String, MessageNumbers.At> all = new LinkedHashMap<>();
    if (message != null) {
      String source = channel.sourceOf(message);
      String suffix = source.isEmpty() ? "" : " (" + source + ")";
      MessageNumbers.of(message).forEach(each -> all.put(each.field() + suffix, each));
    }
    return all;
  }

  public String name() {
    return channel.name();
  }

  /** Number of recorded messages. */
  public long recorded() {
    return recorded;
  }

  /** Number of messages published by the re-execution. */
  public long now() {
    return now;
  }

  /** Number of byte-identical messages. */
  public long same() {
    return same;
  }

  /** Whether every message is identical, with none missing or surplus. */
  public boolean isIdentical() {
    return first == null;
  }

  /** First difference, or empty. */
  public Optional<Difference> first() {
    return Optional.ofNullable(first);
  }

  /** Numbers that ever differ, in order of first difference. */
  public List<NumberComparison> numbers() {
    return new ArrayList<>(numbers.values());
  }
}
