package org.u2sa.recorder.execution;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;

/** Collects the entries of an execution, and hands them on in parts. Belongs to one thread. */
final class PartBuilder {
  private static final long PART_MICROS = 250_000;
  private static final int PART_MESSAGES = 64;
  private static final int PART_BYTES = 1 << 12;
  private static final int LARGEST_PART = 16; // as many times: of a service that never waits

  private final Clock clock;
  private final Consumer<ExecutionPart> parts;
  private final PackedWriter entries = new PackedWriter();
  private final List<ExecutionPart.Passed> messages = new ArrayList<>();
  private String name = ""; // of the execution; empty: not known yet
  private long number;
  private long beganMicros;
  private long baseMicros; // what the next reading is written relative to
  private long readingMicros;
  private long readings; // of the same time, not yet written
  private boolean isLarge; // to be handed on once the message of the entry is there too

  /**
   * @param clock of the run
   * @param parts takes what was noted
   */
  PartBuilder(Clock clock, Consumer<ExecutionPart> parts) {
    this.clock = clock;
    this.parts = parts;
    beganMicros = clock.micros();
  }

  /** Sets the execution's name; nothing is handed on before. */
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

  /** The clock was read. */
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

  /** Whether it is time to hand the part on: it is old or large. */
  boolean isFull() {
    return clock.micros() - beganMicros >= PART_MICROS
        || entries.length() >= PART_BYTES
        || messages.size() >= PART_MESSAGES;
  }

  /** Hands on what was added, and begins the next part. */
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
    baseMicros = 0; // each part can be read by itself
  }
}
