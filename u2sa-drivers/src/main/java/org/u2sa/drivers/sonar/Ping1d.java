package org.u2sa.drivers.sonar;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * Blue Robotics Ping single-beam echo sounder, polled for its distance: message 1211 by request 6
 * (bluerobotics/ping-protocol, ping1d.json).
 */
public final class Ping1d extends LinkedDevice<RangeFinder.Distance> implements RangeFinder {
  private static final int REQUEST = 6;
  private static final int DISTANCE = 1211;
  private static final int DISTANCE_BYTES = 5;
  private static final double MILLI = 1e-3;
  private static final long ASK_EVERY_MICROS = Clock.micros(0.1);
  private static final byte[] AUTO_BAUD = {'U', 'U', 'U', 'U', 'U', 'U', 'U'};

  private final PingFramer framer = new PingFramer(this::take, this::refuse);
  private final int minConfidence;
  private long askDueMicros = Long.MIN_VALUE;
  private long heardMicros; // arrival time of the bytes being parsed

  /**
   * Uses the link; closing the device closes it.
   *
   * @param minConfidence minimum confidence of an echo [%]
   */
  public Ping1d(ByteLink link, int minConfidence) {
    super(link);
    this.minConfidence = minConfidence;
  }

  @Override
  protected void found(long nowMicros) {
    framer.reset();
    askDueMicros = Long.MIN_VALUE;
    link.write(AUTO_BAUD);
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    heardMicros = nowMicros;
    framer.accept(bytes, length);
  }

  private void take(ByteBuffer distance, int id) {
    if (id != DISTANCE || distance.capacity() != DISTANCE_BYTES) {
      return;
    }
    boolean isSure = (distance.get(4) & 0xFF) >= minConfidence;
    double rangeM = (distance.getInt(0) & 0xFFFFFFFFL) * MILLI;
    latest =
        Optional.of(
            new Distance(heardMicros, isSure ? OptionalDouble.of(rangeM) : OptionalDouble.empty()));
  }

  @Override
  protected void act(long nowMicros) {
    if (link.isConnected() && nowMicros >= askDueMicros) {
      askDueMicros = nowMicros + ASK_EVERY_MICROS;
      link.write(PingFramer.of(REQUEST, (byte) DISTANCE, (byte) (DISTANCE >> 8)));
    }
  }

  /** Provider of MODEL = PING1D. */
  public static final class Provider extends LinkProvider<RangeFinder> {
    private record Variables(
        @Variable(unit = "%", min = 0, max = 100, ifAbsent = 50)
            @Description("PING1D: minimum confidence of an echo.")
            int minConfidence) {}

    public Provider() {
      super(
          RangeFinder.class,
          Variables.class,
          (name, link, own) -> new Ping1d(link, own.minConfidence()),
          "PING1D");
    }
  }
}
