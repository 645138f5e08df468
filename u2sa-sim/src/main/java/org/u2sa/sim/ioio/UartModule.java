package org.u2sa.sim.ioio;

/** A UART with line delay. After the firmware's {@code uart.c}. */
final class UartModule {
  private static final int BUFFER = 256;
  private static final int PACKET = 64;
  private static final double FAST_HZ = 4.0e6;
  private static final double SLOW_HZ = 1.0e6;
  private static final int FRAME_BITS = 10; // start, 8 data, stop
  private static final double TICK_S = 1.0e-3;
  private static final int NO_PIN = -1;
  private static final double TOLERANCE = 0.025; // maximum baud-rate mismatch
  private static final int[] USUAL_BAUDS = {
    1200, 2400, 4800, 9600, 14_400, 19_200, 38_400, 57_600, 115_200, 230_400
  };

  private final int number;
  private final PinBank pins;
  private final Pins world;
  private final ByteQueue out; // to the host
  private final ByteQueue received = new ByteQueue(BUFFER);
  private final ByteQueue toSend = new ByteQueue(BUFFER);
  private final ByteQueue line = new ByteQueue(1 << 16); // sent by the device, still in transit
  private final byte[] scratch = new byte[BUFFER];
  private int receivePin = NO_PIN;
  private int baud; // 0: off
  private double bytesPerTick;
  private double receiveCredit;
  private double sendCredit;
  private int freedSinceReport;

  UartModule(int number, PinBank pins, Pins world, ByteQueue out) {
    this.number = number;
    this.pins = pins;
    this.world = world;
    this.out = out;
  }

  void reset() {
    receivePin = NO_PIN;
    configure(0, false, false, 0);
  }

  /** Sets the rate, or turns the UART off with 0. The host is notified only on request. */
  void configure(int rate, boolean fast, boolean twoStopBits, int parity) {
    received.clear();
    toSend.clear();
    line.clear();
    freedSinceReport = 0;
    baud = 0;
    if (rate > 0) {
      baud = nominal((fast ? FAST_HZ : SLOW_HZ) / (rate + 1));
      int bits = FRAME_BITS + (twoStopBits ? 1 : 0) + (parity > 0 ? 1 : 0);
      bytesPerTick = baud * TICK_S / bits;
      freedSinceReport = BUFFER;
    }
  }

  /** Standard baud rate compatible with this one. */
  private static int nominal(double exact) {
    for (int usual : USUAL_BAUDS) {
      if (Math.abs(exact - usual) <= TOLERANCE * usual) {
        return usual;
      }
    }
    return (int) Math.round(exact);
  }

  void reportStatus() {
    out.push(Message.UART_STATUS, number | (baud > 0 ? 0x80 : 0));
  }

  /** Routes a pin to RX, or disconnects it. */
  void receiveAt(int pin, boolean enable) {
    receivePin = enable ? pin : NO_PIN;
  }

  void transmit(byte[] bytes) {
    toSend.push(bytes, 0, bytes.length);
  }

  /** Advances the lines by 1 ms. */
  void tick() {
    if (baud == 0) {
      return;
    }
    listen();
    receiveCredit = line.size() == 0 ? 0.0 : receiveCredit + bytesPerTick;
    int arrived = line.pull(scratch, (int) Math.min(receiveCredit, scratch.length));
    receiveCredit -= arrived;
    for (int i = 0; i < arrived; i++) {
      received.push(scratch, i, 1); // byte by byte: bytes beyond the capacity are lost
    }
    sendCredit = toSend.size() == 0 ? 0.0 : sendCredit + bytesPerTick;
    int sent = toSend.pull(scratch, (int) Math.min(sendCredit, scratch.length));
    sendCredit -= sent;
    if (sent > 0) {
      freedSinceReport += sent;
      pins.transmit(number, baud, scratch, sent);
    }
  }

  private void listen() {
    if (receivePin == NO_PIN) {
      return;
    }
    for (int count = 1; count > 0; ) {
      count = world.received(receivePin, baud, scratch);
      line.push(scratch, 0, count);
    }
  }

  /** Passes received bytes to the host and reports its remaining send credit. */
  void report() {
    int count = received.pull(scratch, PACKET);
    if (count > 0) {
      out.push(Message.UART_DATA, count - 1 | number << 6);
      out.push(scratch, 0, count);
    }
    if (freedSinceReport > BUFFER / 2) {
      int field = number | freedSinceReport << 2;
      out.push(Message.UART_REPORT_TX_STATUS, field & 0xFF, field >> 8);
      freedSinceReport = 0;
    }
  }
}
