package org.u2sa.drivers.gps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.interfaces.time.Clock;

/**
 * Configures a u-blox receiver after each connection: port (CFG-PRT), rate (CFG-RATE) and messages
 * (CFG-MSG), in sequence, each repeated until acknowledged. Rejections are reported and skipped. A
 * silent receiver is retried occasionally, because only its transmit line may be wired.
 */
final class UbxSetup {
  static final int CFG_PRT = 0x0600;
  static final int CFG_MSG = 0x0601;
  static final int CFG_RATE = 0x0608;

  private static final long ANSWERS_WITHIN_MICROS = Clock.micros(0.5);
  private static final long AGAIN_AFTER_MICROS = Clock.micros(5.0);
  private static final int TRIES = 4;

  private static final int UART_1 = 1;
  private static final int MODE_8N1 = 0x08D0;
  private static final short UBX_AND_NMEA_IN = 0x0003;
  private static final short UBX_OUT = 0x0001;
  private static final short TO_GPS_TIME = 1;
  private static final int MS_PER_S = 1_000;

  private final List<Step> steps;
  private final List<String> refusals = new ArrayList<>();
  private int next;
  private int tries;
  private long sentMicros;
  private long idleUntilMicros = Long.MIN_VALUE;
  private boolean isUnanswered;

  private record Step(String name, int kind, byte[] frame) {}

  /**
   * @param navMessages class and id of each message to send once per solution
   * @param baud rate of its first serial port, left unchanged [baud]
   * @param rateHz navigation rate [Hz]
   */
  UbxSetup(List<Integer> navMessages, int baud, double rateHz) {
    steps = new ArrayList<>();
    steps.add(new Step("CFG-PRT", CFG_PRT, port(baud)));
    steps.add(new Step("CFG-RATE", CFG_RATE, rate(rateHz)));
    for (int kind : navMessages) {
      steps.add(
          new Step(
              String.format("CFG-MSG for %02X-%02X", kind >> 8, kind & 0xFF),
              CFG_MSG,
              frame(CFG_MSG, (byte) (kind >> 8), (byte) kind, (byte) 1)));
    }
  }

  private static byte[] port(int baud) {
    ByteBuffer port = ByteBuffer.allocate(20).order(ByteOrder.LITTLE_ENDIAN);
    port.putInt(0, UART_1); // no TX-ready pin
    port.putInt(4, MODE_8N1).putInt(8, baud);
    port.putShort(12, UBX_AND_NMEA_IN).putShort(14, UBX_OUT);
    return frame(CFG_PRT, port.array());
  }

  private static byte[] rate(double rateHz) {
    ByteBuffer rate = ByteBuffer.allocate(6).order(ByteOrder.LITTLE_ENDIAN);
    rate.putShort((short) Math.round(MS_PER_S / rateHz));
    rate.putShort((short) 1); // one solution per measurement
    rate.putShort(TO_GPS_TIME);
    return frame(CFG_RATE, rate.array());
  }

  private static byte[] frame(int kind, byte... payload) {
    return UbxFramer.frame(kind >> 8, kind & 0xFF, payload);
  }

  /** Restarts after a reconnection, because the receiver may have lost its settings. */
  void begin() {
    next = 0;
    tries = 0;
    isUnanswered = false;
    idleUntilMicros = Long.MIN_VALUE;
    refusals.clear();
  }

  /** Whether setup is complete. */
  boolean isDone() {
    return next == steps.size();
  }

  /** Sends due messages; called at each step of the service. */
  void step(ByteLink link, long nowMicros) {
    if (isDone() || nowMicros < idleUntilMicros) {
      return;
    }
    if (tries > 0 && nowMicros - sentMicros < ANSWERS_WITHIN_MICROS) {
      return;
    }
    if (tries == TRIES) {
      isUnanswered = true;
      tries = 0;
      next = 0;
      idleUntilMicros = nowMicros + AGAIN_AFTER_MICROS;
      return;
    }
    if (link.write(steps.get(next).frame)) {
      tries++;
      sentMicros = nowMicros;
    }
  }

  /** Handles an acknowledgement. */
  void answered(int kind, boolean isAccepted) {
    if (isDone() || tries == 0 || steps.get(next).kind != kind) {
      return; // not for the pending message
    }
    if (!isAccepted) {
      refusals.add(steps.get(next).name);
    }
    isUnanswered = false;
    tries = 0;
    next++;
  }

  /** Setup fault; empty if none. */
  String trouble() {
    if (isUnanswered) {
      return "the receiver does not acknowledge its setup (" + steps.get(0).name + ")";
    }
    return refusals.isEmpty() ? "" : "the receiver rejected " + String.join(", ", refusals);
  }
}
