package org.u2sa.drivers.link;

import org.u2sa.device.port.Device;

/** A device on a link with a parser. */
public abstract class ParsedDevice<R extends Device.Reading> extends LinkedDevice<R> {
  private final ByteParser<R> parser;

  /** Uses the link; closing the device closes it. */
  protected ParsedDevice(ByteLink link, ByteParser<R> parser) {
    super(link);
    this.parser = parser;
  }

  @Override
  protected void found(long nowMicros) {
    parser.reset();
  }

  @Override
  protected final void hear(byte[] bytes, int length, long nowMicros) {
    parser.accept(bytes, length, nowMicros);
    latest = parser.latest();
  }

  @Override
  public final long malformed() {
    return parser.refused();
  }

  @Override
  public final String lastRefusal() {
    return parser.lastRefusal();
  }
}
