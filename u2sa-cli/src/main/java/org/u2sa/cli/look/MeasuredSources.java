package org.u2sa.cli.look;

import java.util.ArrayList;
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
 * The rows of a measuring command: one for each source and message type of each channel, with what
 * is measured of its messages and how long ago the last one came. Belongs to one thread.
 */
final class MeasuredSources {
  private static final double MICROS = 1e6;

  private final List<String> columns;
  private final LongFunction<Meter> meterFrom;
  private final Map<Key, Row> rows = new TreeMap<>();

  private record Key(String channel, String source, String type) implements Comparable<Key> {
    @Override
    public int compareTo(Key other) {
      int byChannel = channel.compareTo(other.channel);
      int bySource = byChannel == 0 ? source.compareTo(other.source) : byChannel;
      return bySource == 0 ? type.compareTo(other.type) : bySource;
    }
  }

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

  /**
   * @param columns those of the meters
   * @param meterFrom makes a source's meter that counts from then on [µs of real time]
   */
  MeasuredSources(List<String> columns, LongFunction<Meter> meterFrom) {
    this.columns = columns;
    this.meterFrom = meterFrom;
  }

  /**
   * Takes a message.
   *
   * @param micros when it came [µs of real time]
   * @param beganMicros when measuring began [µs of real time]
   */
  void take(Channel<?> channel, U2SAData message, long micros, long beganMicros) {
    Key key = new Key(channel.name(), channel.sourceOf(message), MessageJson.typeName(message));
    Row row = rows.computeIfAbsent(key, each -> new Row(meterFrom.apply(beganMicros)));
    row.meter.take(micros, message);
    row.lastMicros = micros;
  }

  boolean isEmpty() {
    return rows.isEmpty();
  }

  /** The rows as they are then [µs of real time]. */
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

  /** The same as one JSON object. */
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
