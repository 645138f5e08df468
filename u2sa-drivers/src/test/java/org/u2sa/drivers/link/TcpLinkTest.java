package org.u2sa.drivers.link;

import java.io.IOException;
import java.net.InetAddress;
import org.u2sa.interfaces.SystemClock;

/** A device behind a TCP server. */
class TcpLinkTest extends ByteLinkContract {
  private String address = "";

  @Override
  Device device() throws IOException {
    SocketDevice far = new SocketDevice(InetAddress.getLoopbackAddress());
    address = "tcp:127.0.0.1:" + far.port();
    return new Device() {
      @Override
      public ByteLink open() {
        return ByteLinks.open(address, new SystemClock());
      }

      @Override
      public void says(String text) {
        far.says(text);
      }

      @Override
      public String wasTold() {
        return far.wasTold();
      }

      @Override
      public void unplug() throws IOException {
        far.unplug();
      }

      @Override
      public void plug() throws IOException {
        far.plug();
      }

      @Override
      public void end() throws IOException {
        far.unplug();
      }
    };
  }

  @Override
  String address() {
    return address;
  }
}
