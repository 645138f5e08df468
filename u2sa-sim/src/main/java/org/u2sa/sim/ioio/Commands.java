package org.u2sa.sim.ioio;

import java.util.Locale;
import java.util.Set;
import java.util.function.IntConsumer;
import org.u2sa.sim.ioio.MessageReader.Bits;

/**
 * Executes messages to the board that have valid arguments. After the firmware's {@code protocol.c}
 * and {@code features.c}, with exactly its checks.
 */
final class Commands implements MessageReader.Handler {
  private static final int ENABLE_BIT = 7;
  private static final int TRANSMIT_BIT = 6;
  private static final int PULL_MODES = 3;
  private static final int PARITIES = 3;
  private static final Set<String> INTERFACES =
      Set.of("IOIO0001", "IOIO0002", "IOIO0003", "IOIO0004", "IOIO0005");

  private final IoioBoard board;
  private final Peripherals modules;
  private final ByteQueue out;

  Commands(IoioBoard board, Peripherals modules, ByteQueue out) {
    this.board = board;
    this.modules = modules;
    this.out = out;
  }

  @Override
  public boolean handle(int type, Bits arguments) {
    return switch (type) {
      case Message.SOFT_RESET -> softReset();
      case Message.CHECK_INTERFACE -> checkInterface(arguments);
      case Message.SET_PIN_DIGITAL_OUT -> digitalOut(arguments);
      case Message.SET_DIGITAL_OUT_LEVEL -> digitalOutLevel(arguments);
      case Message.SET_PIN_DIGITAL_IN -> digitalIn(arguments);
      case Message.SET_CHANGE_NOTIFY -> changeNotify(arguments);
      case Message.SET_PIN_PWM -> pinPwm(arguments);
      case Message.SET_PWM_DUTY_CYCLE -> pwmDuty(arguments);
      case Message.SET_PWM_PERIOD -> pwmPeriod(arguments);
      case Message.SET_PIN_ANALOG_IN -> analogIn(arguments);
      case Message.SET_ANALOG_IN_SAMPLING -> analogSampling(arguments);
      case Message.UART_CONFIG -> uartConfig(arguments);
      case Message.UART_DATA -> uartData(arguments);
      case Message.SET_PIN_UART -> pinUart(arguments);
      case Message.INCAP_CONFIG -> captureConfig(arguments);
      case Message.SET_PIN_INCAP -> pinCapture(arguments);
      case Message.SYNC -> sync();
      default ->
          throw new IllegalStateException(
              String.format(
                  Locale.ROOT, "message 0x%02X is not implemented by the simulated board", type));
    };
  }

  private boolean softReset() {
    modules.reset();
    out.push(Message.SOFT_RESET);
    return true;
  }

  private boolean checkInterface(Bits arguments) {
    boolean supported = INTERFACES.contains(arguments.text());
    out.push(Message.CHECK_INTERFACE_RESPONSE, supported ? 1 : 0);
    return true;
  }

  private boolean sync() {
    out.push(Message.SYNC);
    return true;
  }

  private boolean isPin(int pin) {
    return pin < board.pins();
  }

  /** Runs an action on a pin if the pin exists. */
  private boolean with(int pin, IntConsumer action) {
    if (isPin(pin)) {
      action.accept(pin);
    }
    return isPin(pin);
  }

  private boolean digitalOut(Bits arguments) {
    return with(
        arguments.field(0, 2, 6),
        pin -> {
          modules.digital.forget(pin);
          modules.pins.digitalOut(pin, arguments.flag(0, 1));
        });
  }

  private boolean digitalOutLevel(Bits arguments) {
    return with(arguments.field(0, 2, 6), pin -> modules.pins.level(pin, arguments.flag(0, 0)));
  }

  private boolean digitalIn(Bits arguments) {
    int pin = arguments.field(0, 2, 6);
    if (!isPin(pin) || arguments.field(0, 0, 2) >= PULL_MODES) {
      return false;
    }
    modules.digital.forget(pin);
    modules.pins.digitalIn(pin);
    return true;
  }

  private boolean changeNotify(Bits arguments) {
    return with(arguments.field(0, 2, 6), pin -> modules.digital.watch(pin, arguments.flag(0, 0)));
  }

  private boolean pinPwm(Bits arguments) {
    int pin = arguments.field(0, 0, 6);
    int module = arguments.field(1, 0, 4);
    if (!isPin(pin) || module >= PwmModules.COUNT) {
      return false;
    }
    modules.pins.leadPwm(pin, module, arguments.flag(1, ENABLE_BIT));
    return true;
  }

  private boolean pwmDuty(Bits arguments) {
    int module = arguments.field(0, 2, 4);
    if (module >= PwmModules.COUNT) {
      return false;
    }
    modules.pwm.setDuty(module, arguments.word(1), arguments.field(0, 0, 2));
    modules.pins.pwmChanged(module);
    return true;
  }

  private boolean pwmPeriod(Bits arguments) {
    int module = arguments.field(0, 1, 4);
    if (module >= PwmModules.COUNT) {
      return false;
    }
    int scale = arguments.field(0, 0, 1) | arguments.field(0, 7, 1) << 1;
    modules.pwm.setPeriod(module, arguments.word(1), scale);
    modules.pins.pwmChanged(module);
    return true;
  }

  private boolean analogIn(Bits arguments) {
    return with(
        arguments.octet(0),
        pin -> {
          modules.digital.forget(pin);
          modules.pins.analogIn(pin);
        });
  }

  private boolean analogSampling(Bits arguments) {
    return with(
        arguments.field(0, 0, 6), pin -> modules.analog.sample(pin, arguments.flag(0, ENABLE_BIT)));
  }

  private boolean uartConfig(Bits arguments) {
    int parity = arguments.field(0, 0, 2);
    if (parity >= PARITIES) {
      return false;
    }
    UartModule uart = modules.uart(arguments.field(0, 6, 2));
    uart.configure(arguments.word(1), arguments.flag(0, 3), arguments.flag(0, 2), parity);
    uart.reportStatus();
    return true;
  }

  private boolean uartData(Bits arguments) {
    modules.uart(arguments.field(0, 6, 2)).transmit(arguments.from(1));
    return true;
  }

  private boolean pinUart(Bits arguments) {
    int pin = arguments.field(0, 0, 6);
    if (!isPin(pin)) {
      return false;
    }
    int uart = arguments.field(1, 0, 2);
    boolean enable = arguments.flag(1, ENABLE_BIT);
    if (arguments.flag(1, TRANSMIT_BIT)) {
      modules.pins.leadUart(pin, uart, enable);
    } else {
      modules.uart(uart).receiveAt(pin, enable && board.hasPeripheralInput(pin));
    }
    return true;
  }

  private boolean captureConfig(Bits arguments) {
    int module = arguments.field(0, 0, 4);
    boolean isDouble = arguments.flag(1, 7);
    int mode = arguments.field(1, 3, 3);
    boolean isOdd = (module & 1) == 1; // the low half of a pair is even
    if (module >= PulseCapture.COUNT || isDouble && isOdd || mode >= PulseCapture.MODES) {
      return false;
    }
    int clock = arguments.field(1, 0, 2);
    modules.capture(module).configure(isDouble, mode, clock, modules.nowMicros());
    return true;
  }

  private boolean pinCapture(Bits arguments) {
    int pin = arguments.field(0, 0, 6);
    int module = arguments.field(1, 0, 4);
    boolean enable = arguments.flag(1, ENABLE_BIT);
    if (module >= PulseCapture.COUNT || enable && !isPin(pin)) {
      return false;
    }
    modules.capture(module).listenAt(pin, enable && board.hasPeripheralInput(pin));
    return true;
  }
}
