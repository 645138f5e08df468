package org.u2sa.drivers.link;

import java.io.IOException;

/** A device behind a TCP server. */
class TcpLinkTest extends ByteLinkContract {
  @Override
  FarEnd device() throws IOException {
    return FarEnds.tcp();
  }
}
