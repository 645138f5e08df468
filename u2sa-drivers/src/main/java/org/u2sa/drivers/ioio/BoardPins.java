package org.u2sa.drivers.ioio;

import ioio.lib.api.AnalogInput;
import ioio.lib.api.DigitalInput;
import ioio.lib.api.DigitalOutput;
import ioio.lib.api.IOIO;
import ioio.lib.api.PulseInput;
import ioio.lib.api.PwmOutput;
import ioio.lib.api.Uart;
import ioio.lib.api.exception.ConnectionLostException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The pins of one connection, opened through IOIOLib and used without blocking. PWM pins stay low
 * until the first pulse is set. Confined to the service's thread.
 */
final class BoardPins {
  private static final float US_PER_S = 1.0e6f;

  private final List<PwmOutput> pulses = new ArrayList<>();
  private final float[] setUs;
  private final Optional<UartLine> gps;
  private final Optional<UartLine> compass;
  private final Optional<PulseLine> radio;
  private final Optional<DigitalOutput> led;
  private final AnalogInput sample;
  private final boolean ledIsLitLow;
  private boolean ledIsLit;

  /**
   * Opens the pins.
   *
   * @throws IllegalArgumentException if a pin of the connected board lacks a function
   */
  BoardPins(IOIO ioio, PinPlan plan) throws ConnectionLostException {
    for (int pin : plan.pulses()) {
      pulses.add(ioio.openPwmOutput(pin, plan.pulseHz()));
    }
    setUs = new float[pulses.size()];
    sample = ioio.openAnalogInput(plan.sample());
    sample.setBuffer(1); // so that available() reports whether there is a value
    ledIsLitLow = plan.led() == IOIO.LED_PIN;
    led =
        plan.led() == PinPlan.NONE
            ? Optional.empty()
            : Optional.of(ioio.openDigitalOutput(plan.led(), ledIsLitLow));
    radio = plan.radio() == PinPlan.NONE ? Optional.empty() : Optional.of(radio(ioio, plan));
    gps = plan.gps().isPresent() ? Optional.of(uart(ioio, plan.gps().get())) : Optional.empty();
    compass =
        plan.compass().isPresent()
            ? Optional.of(uart(ioio, plan.compass().get()))
            : Optional.empty();
  }

  private static PulseLine radio(IOIO ioio, PinPlan plan) throws ConnectionLostException {
    // pull-down: a detached wire then gives no pulses instead of noise
    DigitalInput.Spec spec = new DigitalInput.Spec(plan.radio(), DigitalInput.Spec.Mode.PULL_DOWN);
    return new PulseLine(
        ioio.openPulseInput(
            spec, PulseInput.ClockRate.RATE_2MHz, PulseInput.PulseMode.POSITIVE, false));
  }

  private static UartLine uart(IOIO ioio, PinPlan.Uart pins) throws ConnectionLostException {
    Uart uart =
        ioio.openUart(
            pins.receive(), pins.transmit(), pins.baud(), Uart.Parity.NONE, Uart.StopBits.ONE);
    return new UartLine(uart, pins.baud());
  }

  /** Sets an output's pulse width [s] if it changed. */
  void pulse(int output, double widthS) throws ConnectionLostException {
    float us = (float) (widthS * US_PER_S);
    if (us != setUs[output]) {
      pulses.get(output).setPulseWidth(us);
      setUs[output] = us;
    }
  }

  /** Switches the LED, if present. */
  void light(boolean lit) throws ConnectionLostException {
    if (led.isPresent() && lit != ledIsLit) {
      led.get().write(lit != ledIsLitLow);
      ledIsLit = lit;
    }
  }

  /** Sends the LED's level again, as a sign of life. */
  void greet() throws ConnectionLostException {
    if (led.isPresent()) {
      led.get().write(ledIsLit != ledIsLitLow);
    }
  }

  /** Voltage at the sampled analog input [V]; empty before the first sample. */
  OptionalDouble volts() throws ConnectionLostException {
    try {
      return sample.available() > 0
          ? OptionalDouble.of(sample.getVoltage()) // does not block: a sample exists
          : OptionalDouble.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return OptionalDouble.empty();
    }
  }

  /** Width [s] of the oldest unread pulse at the radio input; empty if none. */
  OptionalDouble nextRadioPulse() throws ConnectionLostException {
    return radio.isPresent() ? radio.get().next() : OptionalDouble.empty();
  }

  /** In lockstep, inspects board bytes before the library receives them. */
  void comes(byte[] bytes) {
    radio.ifPresent(line -> line.comes(bytes));
  }

  Optional<UartLine> gps() {
    return gps;
  }

  Optional<UartLine> compass() {
    return compass;
  }
}
