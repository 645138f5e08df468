package org.u2sa.drivers.imu;

import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ParsedLink;

/** A VectorNav at the other end of a link. */
public final class LinkedImu implements Imu {
  private final ByteLink link;
  private final VectorNav parser = new VectorNav();
  private final ParsedLink parsed;

  /** Over that link, which is closed with this. */
  public LinkedImu(ByteLink link) {
    this.link = link;
    parsed = new ParsedLink(link, parser);
  }

  @Override
  public Reading read(long nowMicros) {
    parsed.read(nowMicros);
    return new Reading(link.isConnected(), parser.latest());
  }

  @Override
  public long malformed() {
    return parser.refused();
  }

  @Override
  public boolean isConnected() {
    return link.isConnected();
  }

  @Override
  public int connections() {
    return link.connections();
  }

  @Override
  public String trouble() {
    return link.trouble();
  }

  @Override
  public void close() {
    link.close();
  }
}
