package org.u2sa.sim.ioio;

/** All modules of a board, stepped together. */
final class Peripherals {
  private static final int UARTS = 4;

  final PwmModules pwm = new PwmModules();
  final PinBank pins;
  final DigitalInputs digital;
  final AnalogScan analog;
  private final UartModule[] uarts = new UartModule[UARTS];
  private final PulseCapture[] captures = new PulseCapture[PulseCapture.COUNT];
  private long nowMicros;

  Peripherals(IoioBoard board, Pins world, ByteQueue out) {
    pins = new PinBank(board, world, pwm);
    digital = new DigitalInputs(board, world, out);
    analog = new AnalogScan(pins, world, out);
    for (int number = 0; number < UARTS; number++) {
      uarts[number] = new UartModule(number, pins, world, out);
    }
    for (int number = 0; number < captures.length; number++) {
      captures[number] = new PulseCapture(number, world, out);
    }
  }

  UartModule uart(int number) {
    return uarts[number];
  }

  PulseCapture capture(int number) {
    return captures[number];
  }

  /** The time of the last tick [µs]. */
  long nowMicros() {
    return nowMicros;
  }

  /** Resets all modules; all pins float, as after power-up. */
  void reset() {
    pwm.reset();
    pins.reset();
    digital.reset();
    analog.reset();
    for (UartModule uart : uarts) {
      uart.reset();
    }
    for (PulseCapture capture : captures) {
      capture.reset();
    }
  }

  /** Advances by 1 ms. */
  void tick(long now) {
    nowMicros = now;
    digital.tick();
    analog.tick();
    for (PulseCapture capture : captures) {
      capture.tick(now);
    }
    for (UartModule uart : uarts) {
      uart.tick();
    }
    report();
  }

  /** One pass of the firmware's main loop. */
  void report() {
    for (UartModule uart : uarts) {
      uart.report();
    }
  }
}
