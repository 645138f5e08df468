package org.u2sa.report.export;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.report.ReportFile;

/**
 * Exports the numbers of a recording as ULog, for pyulog, PlotJuggler and Flight Review. Each
 * channel and type is a message format, each source an instance of it; flags are 0 or 1, enums
 * their position, points three numbers; texts and lists are left out. Reads the recording twice:
 * first to determine the fields.
 */
public final class UlogRecording {
  private static final int MAX_INSTANCES = 256;
  private static final int MAX_SOURCES = 1 << 16;
  private static final double MICROS_PER_S = 1e6;

  /** A message format: its fields, and its sources with their numbers. */
  private static final class Format {
    private final Set<String> fields = new LinkedHashSet<>();
    private final Map<String, Integer> sources = new LinkedHashMap<>();
  }

  private final RecordedMessages recording;
  private final RecordedSpan span;
  private final Predicate<McapChannel> wanted;
  private final double everyS;
  private final Map<String, Format> formats = new LinkedHashMap<>();
  private int sources;
  private long written;

  /**
   * @param everyS minimum time between two messages of one source [s]
   */
  public UlogRecording(
      RecordedMessages recording, RecordedSpan span, Predicate<McapChannel> wanted, double everyS) {
    this.recording = recording;
    this.span = span;
    this.wanted = wanted;
    this.everyS = everyS;
  }

  /** Writes the file; returns the number of messages in it. */
  public long write(Path file) throws IOException {
    forEach((name, source, numbers, micros) -> learn(name, source, numbers));
    ReportFile.write(
        file,
        out -> {
          OutputStream buffered = new BufferedOutputStream(out);
          write(new UlogWriter(buffered));
          buffered.flush();
        });
    return written;
  }

  private void learn(String name, String source, Map<String, Double> numbers) {
    Format format = formats.computeIfAbsent(name, any -> new Format());
    format.fields.addAll(numbers.keySet());
    boolean hasRoom = format.sources.size() < MAX_INSTANCES && sources < MAX_SOURCES;
    if (hasRoom && format.sources.putIfAbsent(source, sources) == null) {
      sources++;
    }
  }

  private void write(UlogWriter writer) throws IOException {
    writer.info("sys_name", "U2SA");
    writer.info("ver_hw", recording.systemId().orElse("unknown"));
    for (Map.Entry<String, Format> format : formats.entrySet()) {
      writer.format(format.getKey(), format.getValue().fields);
    }
    for (Map.Entry<String, Format> format : formats.entrySet()) {
      int instance = 0;
      for (int id : format.getValue().sources.values()) {
        writer.source(format.getKey(), instance++, id);
      }
    }
    forEach(
        (name, source, numbers, micros) -> {
          Format format = formats.get(name);
          Integer id = format.sources.get(source);
          if (id != null) {
            double[] values = new double[format.fields.size()];
            Arrays.fill(values, Double.NaN);
            int index = 0;
            for (String field : format.fields) {
              values[index++] = numbers.getOrDefault(field, Double.NaN);
            }
            writer.data(id, micros, values);
            written++;
          }
        });
  }

  private interface Taker {
    void take(String name, String source, Map<String, Double> numbers, long micros)
        throws IOException;
  }

  private void forEach(Taker taker) throws IOException {
    Spacing spacing = new Spacing(everyS);
    recording.forEach(
        wanted,
        span,
        (topic, message, nanos) -> {
          double timeS = span.seconds(nanos);
          Map<String, Double> numbers = numbers(message);
          if (!numbers.isEmpty() && spacing.takes(topic, message, timeS)) {
            String source = Channels.namedOrNew(topic.channel()).sourceOf(message);
            taker.take(name(topic), source, numbers, Math.round(timeS * MICROS_PER_S));
          }
        });
  }

  /** The channel name, with the type if the channel has several. */
  private static String name(Topic topic) {
    List<String> chain = topic.typeChain();
    String channel = topic.channel();
    boolean isOnly =
        Channels.named(channel)
            .filter(known -> known.carriedTypes().size() == 1 && chain.size() == 1)
            .isPresent();
    String name = isOnly ? channel : channel + "_" + chain.get(chain.size() - 1);
    return name.replaceAll("[^A-Za-z0-9_]", "_");
  }

  private static Map<String, Double> numbers(U2SAData message) {
    Map<String, Double> numbers = new LinkedHashMap<>();
    for (FieldValue field : message.enumerateFields()) {
      Object value = field.value().orElse(null);
      String name = field.name().replaceAll("[^A-Za-z0-9_]", "_");
      if (value instanceof Point point) {
        numbers.put(name + "_x", point.x());
        numbers.put(name + "_y", point.y());
        numbers.put(name + "_z", point.z());
      } else if (!name.equals("timestamp")) {
        number(value).ifPresent(number -> numbers.put(name, number));
      }
    }
    return numbers;
  }

  private static OptionalDouble number(Object value) {
    if (value instanceof Number number) {
      return OptionalDouble.of(number.doubleValue());
    }
    if (value instanceof Boolean flag) {
      return OptionalDouble.of(flag ? 1.0 : 0.0);
    }
    return value instanceof Enum<?> constant
        ? OptionalDouble.of(constant.ordinal())
        : OptionalDouble.empty();
  }
}
