package org.u2sa.drivers.range;

import org.u2sa.drivers.link.ByteLink;

/** A sonar on a link that measures by itself, again and again. */
final class SerialSonar implements RangeFinder {
  private final ByteLink link;
  private final SonarParser parser;
  private final byte[] buffer = new byte[256];
  private int connections;

  SerialSonar(ByteLink link, SonarModel model) {
    this.link = link;
    this.parser = new SonarParser(model);
  }

  @Override
  public Reading read(long nowMicros) {
    if (link.connections() != connections) {
      connections = link.connections();
      parser.beginAnew();
    }
    int count;
    while ((count = link.read(buffer)) > 0) {
      parser.accept(buffer, count, nowMicros);
    }
    return parser.latest();
  }

  @Override
  public long malformed() {
    return parser.malformed();
  }

  @Override
  public void close() {
    link.close();
  }
}
