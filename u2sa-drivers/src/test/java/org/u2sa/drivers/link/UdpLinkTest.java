package org.u2sa.drivers.link;

import java.io.IOException;

/** A device that answers datagrams. */
class UdpLinkTest extends ByteLinkContract {
  @Override
  FarEnd device() throws IOException {
    return FarEnds.udp();
  }
}
