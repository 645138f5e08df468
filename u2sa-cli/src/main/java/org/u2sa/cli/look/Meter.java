package org.u2sa.cli.look;

import java.util.List;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.U2SAData;

/** What is measured of one source's messages. */
interface Meter {
  /**
   * Takes a message.
   *
   * @param micros when it came [µs of real time]
   */
  void take(long micros, U2SAData message);

  /**
   * The cells of the row, in the order of the columns.
   *
   * @param nowMicros when it is asked [µs of real time]
   */
  List<String> cells(long nowMicros);

  /** Adds the same as numbers. */
  void addTo(JsonText json, long nowMicros);
}
