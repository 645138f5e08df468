package org.u2sa.cli.describe;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.u2sa.cli.describe.VehicleComposition.HeardSource;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.U2SAData;

/** Observation of one source: its latest message of one type, and its rate. */
final class SourceRecord {
  private static final List<String> ABOUT_THE_MESSAGE =
      List.of("systemId", "timestamp", "sensorName", "referenceFrame", "uid");
  private static final MathContext FOUR_DIGITS = new MathContext(4);
  private static final String SIGMA = "Sigma";

  private final String channel;
  private final String type;
  private final String sensor;
  private final Map<String, String> facts;
  private final long firstMicros;
  private long lastMicros;
  private long messages = 1;

  SourceRecord(String channel, U2SAData message) {
    this.channel = channel;
    List<String> chain = message.typeChain();
    type = chain.get(chain.size() - 1);
    sensor = sensor(message);
    facts = facts(message, field -> !ABOUT_THE_MESSAGE.contains(field));
    firstMicros = message.timestamp().orElse(0);
    lastMicros = firstMicros;
  }

  private static String sensor(U2SAData message) {
    if (message instanceof StateInformation state) {
      return state.sensorName();
    }
    return message instanceof RangeScan scan ? scan.sensorName() : "";
  }

  String key() {
    return channel + "\n" + sensor + "\n" + type;
  }

  /** Copy updated with another message. Fields that are only set occasionally are kept. */
  SourceRecord with(SourceRecord newer) {
    facts.putAll(newer.facts);
    lastMicros = newer.lastMicros;
    messages++;
    return this;
  }

  HeardSource heard() {
    List<String> fields = new ArrayList<>();
    Map<String, String> sigmas = new LinkedHashMap<>();
    facts.forEach(
        (name, value) -> {
          if (name.endsWith(SIGMA)) {
            sigmas.put(name.substring(0, name.length() - SIGMA.length()), value);
          } else {
            fields.add(name);
          }
        });
    double spanS = Clock.seconds(lastMicros - firstMicros);
    return new HeardSource(
        channel, sensor, type, spanS > 0.0 ? (messages - 1) / spanS : 0.0, fields, sigmas);
  }

  /** Set fields of a message, with units. */
  static Map<String, String> facts(U2SAData message, Predicate<String> wanted) {
    return factsOf(message, message.type().fields(), wanted);
  }

  @SuppressWarnings("unchecked") // the fields belong to the message
  private static <T extends U2SAData> Map<String, String> factsOf(
      T message, List<? extends MessageField<?>> fields, Predicate<String> wanted) {
    Map<String, String> facts = new LinkedHashMap<>();
    for (MessageField<?> each : fields) {
      MessageField<T> field = (MessageField<T>) each;
      if (wanted.test(field.name()) && field.isSet(message)) {
        String unit = field.unitIn(message);
        facts.put(
            field.name(),
            text(field.get(message).orElseThrow()) + (unit.isEmpty() ? "" : " " + unit));
      }
    }
    facts.keySet().removeAll(List.of("systemId", "timestamp"));
    return facts;
  }

  /** Formats a value; numbers with four digits. */
  static String text(Object value) {
    if (value instanceof Double number) {
      return number == Math.rint(number) && Math.abs(number) < 1e9
          ? String.valueOf(number.longValue())
          : new BigDecimal(number, FOUR_DIGITS).stripTrailingZeros().toPlainString();
    }
    return String.valueOf(value);
  }
}
