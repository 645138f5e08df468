package org.u2sa.sim.ioio;

import java.util.Arrays;

/** Pin modes and the resulting outputs at the pins. */
final class PinBank {
  private static final int NO_MODULE = -1;
  private static final int LED = 0;

  /** Output of a pin: none, a level, or pulses. */
  private record Signal(boolean drives, boolean high, PulseTrain pulses) {
    static final Signal NOTHING = new Signal(false, false, PulseTrain.NONE);
  }

  private final IoioBoard board;
  private final Pins world;
  private final PwmModules pwm;
  private final boolean[] output;
  private final boolean[] level;
  private final boolean[] analog;
  private final int[] pwmModule; // routed to the pin
  private final int[] uartModule; // whose TX is routed to the pin
  private final Signal[] seen;

  PinBank(IoioBoard board, Pins world, PwmModules pwm) {
    this.board = board;
    this.world = world;
    this.pwm = pwm;
    int pins = board.pins();
    output = new boolean[pins];
    level = new boolean[pins];
    analog = new boolean[pins];
    pwmModule = new int[pins];
    uartModule = new int[pins];
    seen = new Signal[pins];
    Arrays.fill(pwmModule, NO_MODULE);
    Arrays.fill(uartModule, NO_MODULE);
    Arrays.fill(seen, Signal.NOTHING);
  }

  /** Resets all pins to inputs; the LED is off. */
  void reset() {
    for (int pin = 0; pin < board.pins(); pin++) {
      becomes(pin, pin == LED, true, false);
    }
  }

  void digitalOut(int pin, boolean high) {
    becomes(pin, true, high, false);
  }

  void digitalIn(int pin) {
    becomes(pin, false, level[pin], false);
  }

  void analogIn(int pin) {
    becomes(pin, false, level[pin], true);
  }

  /** Sets a mode that disconnects any peripheral from the pin. */
  private void becomes(int pin, boolean isOutput, boolean high, boolean isAnalog) {
    output[pin] = isOutput;
    level[pin] = high;
    analog[pin] = isAnalog;
    lead(pin, NO_MODULE, NO_MODULE);
  }

  void level(int pin, boolean high) {
    level[pin] = high;
    refresh(pin);
  }

  boolean isAnalog(int pin) {
    return analog[pin];
  }

  /** Routes a PWM module to a pin, or disconnects it; no effect on a pin without PWM. */
  void leadPwm(int pin, int module, boolean enable) {
    if (board.hasPeripheralOutput(pin)) {
      lead(pin, enable ? module : NO_MODULE, NO_MODULE);
    }
  }

  /** Routes a UART's TX to a pin, or disconnects it. */
  void leadUart(int pin, int module, boolean enable) {
    if (board.hasPeripheralOutput(pin)) {
      lead(pin, NO_MODULE, enable ? module : NO_MODULE);
    }
  }

  private void lead(int pin, int pwmTo, int uartTo) {
    pwmModule[pin] = pwmTo;
    uartModule[pin] = uartTo;
    refresh(pin);
  }

  /** Updates the pins driven by a PWM module. */
  void pwmChanged(int module) {
    for (int pin = 0; pin < board.pins(); pin++) {
      if (pwmModule[pin] == module) {
        refresh(pin);
      }
    }
  }

  /** Sends bytes to the pins driven by a UART's TX. */
  void transmit(int module, int baud, byte[] bytes, int length) {
    for (int pin = 0; pin < board.pins(); pin++) {
      if (uartModule[pin] == module) {
        world.transmitted(pin, baud, bytes, length);
      }
    }
  }

  private void refresh(int pin) {
    Signal before = seen[pin];
    Signal now = signal(pin);
    if (now.equals(before)) {
      return;
    }
    seen[pin] = now;
    if (!now.drives) {
      world.released(pin);
    } else if (pwmModule[pin] != NO_MODULE) {
      world.driven(pin, now.pulses);
    } else {
      world.driven(pin, now.high);
    }
  }

  private Signal signal(int pin) {
    if (pwmModule[pin] != NO_MODULE) {
      return new Signal(true, false, pwm.pulses(pwmModule[pin]));
    }
    boolean idleLine = uartModule[pin] != NO_MODULE; // high between bytes
    return output[pin] || idleLine
        ? new Signal(true, idleLine || level[pin], PulseTrain.NONE)
        : Signal.NOTHING;
  }
}
