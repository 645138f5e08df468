package org.u2sa.cli.look;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.LongFunction;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.message.MessageJson;

/**
 * Rows of a measuring command, one per channel, source and message type, with the measurements and
 * the time since the last message. Not thread-safe.
 */
final class MeasuredSources {
  private static final double MICROS = 1e6;

  private final List<String> columns;
  private final LongFunction<Meter> meterFrom;
  private final Map<Key, Row> rows =
      new TreeMap<>(
          Comparator.comparing(Key::channel).thenComparing(Key::source).thenComparing(Key::type));

  private record Key(String channel, String source, String type) {}

  private static final class Row {
    private final Meter meter;
    private long lastMicros;

    Row(Meter meter) {
      this.meter = meter;
    }

    double agoS(long nowMicros) {
      return (nowMicros - lastMicros) / MICROS;
    }
  }

  /** Creates each source's meter with its start time [µs of real time]. */
  MeasuredSources(List<String> columns, LongFunction<Meter> meterFrom) {
    this.columns = columns;
    this.meterFrom = meterFrom;
  }

  /** Adds a message that arrived at {@code micros}; measurement began at {@code beganMicros}. */
  void take(Channel<?> channel, U2SAData message, long micros, long beganMicros) {
    Key key = new Key(channel.name(), channel.sourceOf(message), MessageJson.typeName(message));
    Row row = rows.computeIfAbsent(key, each -> new Row(meterFrom.apply(beganMicros)));
    row.meter.take(micros, message);
    row.lastMicros = micros;
  }

  boolean isEmpty() {
    return rows.isEmpty();
  }

  /** Rows at the given time [µs of real time]. */
  TextTable table(long nowMicros) {
    List<String> heads = new ArrayList<>(List.of("CHANNEL", "SOURCE", "TYPE"));
    heads.addAll(columns);
    heads.add("LAST");
    TextTable table = new TextTable(heads.toArray(String[]::new));
    rows.forEach(
        (key, row) -> {
          List<String> cells = new ArrayList<>(List.of(key.channel, key.source, key.type));
          cells.addAll(row.meter.cells(nowMicros));
          cells.add(String.format(Locale.ROOT, "%.1f s ago", row.agoS(nowMicros)));
          table.add(cells.toArray(String[]::new));
        });
    return table;
  }

  String json(long nowMicros) {
    List<JsonText> channels = new ArrayList<>();
    rows.forEach(
        (key, row) -> {
          JsonText channel =
              new JsonText()
                  .put("channel", key.channel)
                  .put("source", key.source)
                  .put("type", key.type)
                  .put("lastAgoS", row.agoS(nowMicros));
          row.meter.addTo(channel, nowMicros);
          channels.add(channel);
        });
    return new JsonText().put("channels", channels).line();
  }
}
