package org.u2sa.drivers.link;

import java.util.Optional;
import org.u2sa.device.port.Device;

/** A device on a link with a parser. */
public abstract class ParsedDevice<R extends Device.Reading> extends LinkedDevice<R> {
  private final ByteParser<R> parser;
  private Optional<R> parsed = Optional.empty(); // newest of the parser

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
    Optional<R> newest = parser.latest();
    if (newest != parsed) {
      parsed = newest;
      latest = newest.isPresent() && !isNews(newest.get()) ? latest : newest;
    }
  }

  /**
   * Whether a parsed reading is a measurement of its time. False if the device may have repeated an
   * older one, or the bytes have waited.
   */
  protected boolean isNews(R reading) {
    return true;
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
