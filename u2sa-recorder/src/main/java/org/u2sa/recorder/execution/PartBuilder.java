package org.u2sa.recorder.execution;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;

/** Collects the entries of an execution and passes them on in parts. Not thread-safe. */
final class PartBuilder {
  private static final long PART_MICROS = 250_000;
  private static final int PART_MESSAGES = 64;
  private static final int PART_BYTES = 1 << 12;
  private static final int LARGEST_PART = 16; // factor, if it never waits

  private final Clock clock;
  private final Consumer<ExecutionPart> parts;
  private final PackedWriter entries = new PackedWriter();
  private final List<ExecutionPart.Passed> messages = new ArrayList<>();
  private String name = ""; // of the execution; empty until known
  private long number;
  private long beganMicros;
  private long baseMicros; // reference of the next reading
  private long readingMicros;
  private long readings; // readings of the same time, not yet written
  private boolean isLarge; // pass on once the entry's message was added

  PartBuilder(Clock clock, Consumer<ExecutionPart> parts) {
    this.clock = clock;
    this.parts = parts;
    beganMicros = clock.micros();
  }

  /** Sets the execution's name; no part is passed on before. */
  void name(String execution) {
    name = execution;
  }

  void add(Kind kind, long micros) {
    writeReadings();
    new ExecutionEntry(kind, micros, 1).write(entries, baseMicros);
    isLarge |=
        entries.length() >= LARGEST_PART * PART_BYTES
            || messages.size() >= LARGEST_PART * PART_MESSAGES;
  }

  void add(Kind kind, long micros, Channel<?> channel, U2SAData message) {
    add(kind, micros);
    messages.add(new ExecutionPart.Passed(channel, message));
  }

  void addReading(long micros) {
    if (isLarge) {
      handOn();
    }
    if (readings > 0 && micros != readingMicros) {
      writeReadings();
    }
    readingMicros = micros;
    readings++;
  }

  private void writeReadings() {
    if (readings > 0) {
      new ExecutionEntry(Kind.READING, readingMicros, readings).write(entries, baseMicros);
      baseMicros = readingMicros;
      readings = 0;
    }
  }

  /** Whether the part is old or large enough to be passed on. */
  boolean isFull() {
    return clock.micros() - beganMicros >= PART_MICROS
        || entries.length() >= PART_BYTES
        || messages.size() >= PART_MESSAGES;
  }

  /** Passes on the current part and starts the next. */
  void handOn() {
    if (name.isEmpty()) {
      return;
    }
    writeReadings();
    beganMicros = clock.micros();
    parts.accept(
        new ExecutionPart(
            name, number++, beganMicros, entries.toBytes(), new ArrayList<>(messages)));
    entries.clear();
    messages.clear();
    isLarge = false;
    baseMicros = 0; // each part is self-contained
  }
}
