package org.u2sa.drivers.link;

import org.u2sa.interfaces.communication.SerialLine;
import org.u2sa.interfaces.communication.SerialLineProvider;
import org.u2sa.interfaces.time.Clock;

/** Serial ports as links to devices have them. */
public final class SerialLines implements SerialLineProvider {
  @Override
  public SerialLine open(String path, int baud, Clock clock) {
    ByteLink link = ByteLinks.open("serial:" + path + "?baud=" + baud, clock);
    return new SerialLine() {
      @Override
      public int read(byte[] buffer) {
        link.connections(); // what is read need not be of one connection: packets have checksums
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
