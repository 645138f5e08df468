package org.u2sa.drivers.mavlink;

import org.u2sa.device.port.Device;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.mavlink.MavlinkStream;

/**
 * A receive-only MAVLink device for one message type from any sender. Uses a ground station's
 * address but never transmits.
 */
abstract class MavlinkListener<R extends Device.Reading> extends LinkedDevice<R> {
  private static final int OWN_SYSTEM = 255;
  private static final int OWN_COMPONENT = 191;

  private final MavlinkStream stream = new MavlinkStream(OWN_SYSTEM, OWN_COMPONENT);

  MavlinkListener(ByteLink link) {
    super(link);
  }

  /** Handles a message of any type. */
  abstract void take(Object payload, long nowMicros);

  @Override
  protected final void found(long nowMicros) {
    stream.reset();
  }

  @Override
  protected final void hear(byte[] bytes, int length, long nowMicros) {
    stream.accept(bytes, length, message -> take(message.payload(), nowMicros));
  }

  /** Number of damaged and rejected messages. */
  @Override
  public final long malformed() {
    return stream.malformed() + super.malformed();
  }

  @Override
  public final String lastRefusal() {
    String own = super.lastRefusal();
    return own.isEmpty() ? stream.lastRefusal() : own;
  }
}
