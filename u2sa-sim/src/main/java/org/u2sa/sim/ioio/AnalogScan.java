package org.u2sa.sim.ioio;

/** Samples the analog inputs at 1 kHz. After the firmware's {@code adc.c}. */
final class AnalogScan {
  private static final double REFERENCE_V = 3.3;
  private static final int STEPS = 1024;
  private static final int GROUP = 4; // channels whose low bits are packed into one byte

  private final PinBank pins;
  private final Pins world;
  private final ByteQueue out;
  private int wanted; // requested channels, as a bit mask
  private int reported; // channels in the report format last sent to the host

  AnalogScan(PinBank pins, Pins world, ByteQueue out) {
    this.pins = pins;
    this.world = world;
    this.out = out;
  }

  void reset() {
    wanted = 0;
    reported = 0;
  }

  void sample(int pin, boolean enable) {
    int channel = IoioBoard.analogChannel(pin);
    if (channel < 0) {
      return;
    }
    wanted = enable ? wanted | 1 << channel : wanted & ~(1 << channel);
    if (wanted == 0 && reported != 0) {
      reportFormat();
    }
  }

  /** Advances by 1 ms. */
  void tick() {
    if (wanted == 0) {
      return;
    }
    if (wanted != reported) {
      reportFormat();
    }
    reportValues();
  }

  private void reportFormat() {
    reported = wanted;
    out.push(Message.REPORT_ANALOG_IN_FORMAT, Integer.bitCount(reported));
    for (int channel = 0; channel < IoioBoard.analogChannels(); channel++) {
      if ((reported >> channel & 1) == 1) {
        out.push(IoioBoard.analogPin(channel));
      }
    }
  }

  private void reportValues() {
    int count = Integer.bitCount(reported);
    byte[] values = new byte[count + (count + GROUP - 1) / GROUP];
    int used = 0;
    int header = 0;
    int index = 0;
    for (int channel = 0; channel < IoioBoard.analogChannels(); channel++) {
      if ((reported >> channel & 1) == 0) {
        continue;
      }
      if (index % GROUP == 0) {
        header = used++;
      }
      int value = measure(IoioBoard.analogPin(channel));
      values[header] |= (byte) ((value & 3) << index % GROUP * 2);
      values[used++] = (byte) (value >> 2);
      index++;
    }
    out.push(Message.REPORT_ANALOG_IN_STATUS);
    out.push(values, 0, used);
  }

  private int measure(int pin) {
    double volts = pins.isAnalog(pin) ? world.volts(pin) : 0.0;
    return (int) Math.max(0.0, Math.min(STEPS - 1.0, Math.floor(volts / REFERENCE_V * STEPS)));
  }
}
