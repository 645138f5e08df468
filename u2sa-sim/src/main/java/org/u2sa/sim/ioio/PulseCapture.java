package org.u2sa.sim.ioio;

/**
 * A capture module that measures the time between two edges at a pin, at most 200 times per second.
 * After the firmware's {@code incap.c}. Assumes rising edges at multiples of the period.
 */
final class PulseCapture {
  static final int COUNT = 9;
  static final int MODES = 6; // off, positive, negative, one, four and sixteen periods

  private static final int POSITIVE = 1;
  private static final int NEGATIVE = 2;
  private static final int[] PERIODS = {0, 0, 0, 1, 4, 16}; // by mode
  private static final double[] CLOCKS_HZ = {16.0e6, 2.0e6, 250.0e3, 62.5e3};
  private static final double REARM_MICROS = 5008.0; // timer 5: 313 clocks of 62.5 kHz
  private static final double MICROS = 1.0e6;
  private static final int NO_PIN = -1;
  private static final int BYTE_BITS = 8;

  private final int number;
  private final Pins world;
  private final ByteQueue out;
  private int pin = NO_PIN;
  private int mode;
  private int clock;
  private boolean isDouble;
  private double armedMicros;

  PulseCapture(int number, Pins world, ByteQueue out) {
    this.number = number;
    this.world = world;
    this.out = out;
  }

  void reset() {
    pin = NO_PIN;
    mode = 0;
  }

  void listenAt(int newPin, boolean enable) {
    pin = enable ? newPin : NO_PIN;
  }

  void configure(boolean doublePrecision, int newMode, int newClock, long nowMicros) {
    isDouble = doublePrecision;
    mode = newMode;
    clock = newClock;
    rearm(nowMicros);
    out.push(Message.INCAP_STATUS, number | (mode > 0 ? 0x80 : 0));
  }

  private void rearm(double afterMicros) {
    armedMicros = (Math.floor(afterMicros / REARM_MICROS) + 1.0) * REARM_MICROS;
  }

  /** Reports completed measurements. */
  void tick(long nowMicros) {
    if (mode == 0 || pin == NO_PIN) {
      return;
    }
    PulseTrain train = world.pulses(pin);
    if (!train.present()) {
      armedMicros = Math.max(armedMicros, nowMicros); // ignore edges before the first
      return;
    }
    double periodMicros = train.periodS() * MICROS;
    double widthMicros = train.widthS() * MICROS;
    double span = span(periodMicros, widthMicros);
    double phase = mode == NEGATIVE ? widthMicros : 0.0;
    while (true) {
      double end = Math.ceil((armedMicros - phase) / periodMicros) * periodMicros + phase + span;
      if (end > nowMicros) {
        return;
      }
      report(span);
      rearm(end);
    }
  }

  private double span(double periodMicros, double widthMicros) {
    if (mode == POSITIVE) {
      return widthMicros;
    }
    return mode == NEGATIVE ? periodMicros - widthMicros : PERIODS[mode] * periodMicros;
  }

  private void report(double spanMicros) {
    long counted = Math.round(spanMicros * CLOCKS_HZ[clock] / MICROS);
    long held = counted & (isDouble ? 0xFFFFFFFFL : 0xFFFFL);
    int size = 1;
    while (held >> size * BYTE_BITS != 0) {
      size++;
    }
    byte[] message = new byte[size + 2];
    message[0] = Message.INCAP_REPORT;
    message[1] = (byte) (number | (size & 3) << 6); // 0 stands for 4
    for (int i = 0; i < size; i++) {
      message[2 + i] = (byte) (held >> i * BYTE_BITS);
    }
    out.push(message, 0, message.length);
  }
}
