package org.u2sa.messages.schema;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One message or more of every type, whose bytes lie in docs/wire/golden. Never change one: add.
 */
final class GoldenMessages {
  static final long MICROS = 1_700_000_000_123_456L;

  private final Map<String, U2SAData> byName = new LinkedHashMap<>();

  private GoldenMessages() {}

  static Map<String, U2SAData> all() {
    GoldenMessages golden = new GoldenMessages();
    GoldenModel.addTo(golden);
    GoldenContract.addTo(golden);
    GoldenFormat2.addTo(golden);
    GoldenFormat3.addTo(golden);
    GoldenWorld.addTo(golden);
    return golden.byName;
  }

  void add(String name, U2SAData message) {
    message.systemId("cessna");
    message.timestamp(MICROS);
    addAsItIs(name, message);
  }

  /** Adds a message whose system or time is its own matter. */
  void addAsItIs(String name, U2SAData message) {
    byName.put(name, message);
  }
}
