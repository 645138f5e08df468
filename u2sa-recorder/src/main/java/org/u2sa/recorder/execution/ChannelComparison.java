package org.u2sa.recorder.execution;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.McapException;

/** What a service published on one channel, in the recording and when executed again. */
public final class ChannelComparison {
  private final Channel<?> channel;
  private long recorded;
  private long now;
  private long same;
  private long pairs;
  private Difference first; // null: none
  private final Map<String, NumberDeviation> deviations = new LinkedHashMap<>();

  /**
   * The first difference.
   *
   * @param micros when [µs of the run's clock]
   * @param field what differs; its path is empty where a message is missing, or one too many
   */
  public record Difference(long micros, FieldDifference field) {}

  /** How far a number was from the recorded one. */
  public static final class NumberDeviation {
    private double sumOfSquares;
    private double largest;

    private void add(double deviation) {
      sumOfSquares += deviation * deviation;
      largest = Math.max(largest, Math.abs(deviation));
    }

    /** Root of the mean square over so many messages, in the field's unit. */
    public double rms(long messages) {
      return Math.sqrt(sumOfSquares / messages);
    }

    /** The largest, without sign, in the field's unit. */
    public double largest() {
      return largest;
    }
  }

  ChannelComparison(Channel<?> channel) {
    this.channel = channel;
  }

  void add(long micros, RecordedMessage before, U2SAData after) throws McapException {
    recorded += before == null ? 0 : 1;
    now += after == null ? 0 : 1;
    if (before == null) {
      differs(micros, new FieldDifference("", "no message", after.type().name()));
    } else if (after == null) {
      differs(micros, new FieldDifference("", before.typeName(), "no message"));
    } else if (before.is(after)) {
      pairs++;
      same++;
    } else {
      pairs++;
      U2SAData decoded = before.decoded();
      differs(
          micros,
          FieldDifference.between(decoded, after)
              .orElse(new FieldDifference("(encoding)", "other bytes", "other bytes")));
      deviate(decoded, after);
    }
  }

  private void differs(long micros, FieldDifference field) {
    if (first == null) {
      first = new Difference(micros, field);
    }
  }

  private void deviate(U2SAData before, U2SAData after) {
    Map<String, Double> ofBefore = new LinkedHashMap<>();
    FieldDifference.numbers(before).forEach(one -> ofBefore.put(one.field(), one.value()));
    for (FieldDifference.NumberAt one : FieldDifference.numbers(after)) {
      Double other = ofBefore.get(one.field());
      if (other != null && other != one.value()) {
        deviations
            .computeIfAbsent(one.field(), name -> new NumberDeviation())
            .add(one.value() - other);
      }
    }
  }

  /** The channel's name. */
  public String name() {
    return channel.name();
  }

  /** Messages in the recording. */
  public long recorded() {
    return recorded;
  }

  /** Messages of the service that was executed again. */
  public long now() {
    return now;
  }

  /** Messages that are the same to the byte. */
  public long same() {
    return same;
  }

  /** Messages that stand in both, at the same place. */
  public long pairs() {
    return pairs;
  }

  /** Whether every message is the same, and none is missing or too many. */
  public boolean isIdentical() {
    return first == null;
  }

  /** Where they differ first; empty if they do not. */
  public Optional<Difference> first() {
    return Optional.ofNullable(first);
  }

  /** Numbers that deviate, by the paths of their fields. */
  public Map<String, NumberDeviation> deviations() {
    return new LinkedHashMap<>(deviations);
  }
}
