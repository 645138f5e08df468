package org.u2sa.drivers.link;

import org.u2sa.interfaces.communication.SerialLine;
import org.u2sa.interfaces.communication.SerialLineProvider;
import org.u2sa.interfaces.time.Clock;

/** Serial ports, as used by links to devices. */
public final class SerialLines implements SerialLineProvider {
  @Override
  public SerialLine open(String path, int baud, Clock clock) {
    ByteLink link = ByteLinks.open("serial:" + path + "?baud=" + baud, clock);
    return new SerialLine() {
      @Override
      public int read(byte[] buffer) {
        link.connections(); // data may span connections: packets have checksums
        return link.read(buffer);
      }

      @Override
      public boolean write(byte[] bytes) {
        return link.write(bytes);
      }

      @Override
      public void close() {
        link.close();
      }
    };
  }
}
