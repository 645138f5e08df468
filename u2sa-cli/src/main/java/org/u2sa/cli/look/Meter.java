package org.u2sa.cli.look;

import java.util.List;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.U2SAData;

/** Measures one source's messages. */
interface Meter {
  /** Adds a message, with its time of arrival [µs of real time]. */
  void take(long micros, U2SAData message);

  /** Cells of the row, in column order, at a time [µs of real time]. */
  List<String> cells(long nowMicros);

  /** Adds the same values as numbers. */
  void addTo(JsonText json, long nowMicros);
}
