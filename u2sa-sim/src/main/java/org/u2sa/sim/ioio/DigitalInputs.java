package org.u2sa.sim.ioio;

import java.util.Arrays;

/** Reports changes of digital inputs to the host on request. After the firmware's digital.c. */
final class DigitalInputs {
  private final Pins world;
  private final ByteQueue out;
  private final boolean[] watched;
  private final boolean[] known;

  DigitalInputs(IoioBoard board, Pins world, ByteQueue out) {
    this.world = world;
    this.out = out;
    watched = new boolean[board.pins()];
    known = new boolean[board.pins()];
  }

  void reset() {
    Arrays.fill(watched, false);
  }

  /** Ends reporting silently when the pin changes mode. */
  void forget(int pin) {
    watched[pin] = false;
  }

  void watch(int pin, boolean enable) {
    watched[pin] = enable;
    out.push(Message.SET_CHANGE_NOTIFY, pin << 2 | (enable ? 1 : 0));
    if (enable) {
      report(pin, world.high(pin));
    }
  }

  void tick() {
    for (int pin = 0; pin < watched.length; pin++) {
      if (watched[pin] && world.high(pin) != known[pin]) {
        report(pin, !known[pin]);
      }
    }
  }

  private void report(int pin, boolean high) {
    known[pin] = high;
    out.push(Message.REPORT_DIGITAL_IN_STATUS, pin << 2 | (high ? 1 : 0));
  }
}
