package org.u2sa.drivers.link;

/** A link whose bytes go to a parser, which begins anew with each connection. For one thread. */
public final class ParsedLink {
  private static final int BUFFER_BYTES = 1_024;
  private static final int MOST_BYTES_A_READ = 1 << 20; // a flood must not hold its reader for ever

  private final ByteLink link;
  private final ByteParser parser;
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private int connections;

  /** Over that link, which the owner of this closes. */
  public ParsedLink(ByteLink link, ByteParser parser) {
    this.link = link;
    this.parser = parser;
  }

  /**
   * Hands what has come to the parser.
   *
   * @return whether the device was found anew since the last call: it may have to be set up
   */
  public boolean read(long nowMicros) {
    boolean isNew = link.connections() != connections;
    if (isNew) {
      connections = link.connections();
      parser.reset();
    }
    int left = MOST_BYTES_A_READ;
    int count = 1;
    while (count > 0 && left > 0) {
      count = link.read(buffer);
      parser.accept(buffer, count, nowMicros);
      left -= count;
    }
    return isNew;
  }

  /** The link. */
  public ByteLink link() {
    return link;
  }
}
