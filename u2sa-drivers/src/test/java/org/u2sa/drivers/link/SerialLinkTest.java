package org.u2sa.drivers.link;

import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.SystemClock;

/** A device on a serial line, which is a pair of pseudo terminals here. */
class SerialLinkTest extends ByteLinkContract {
  @TempDir Path folder;
  private String address = "";

  @Override
  Device device() throws Exception {
    SerialCable cable = SerialCable.required(folder.resolve("ttyTEST"));
    address = "serial:" + cable.path() + "?baud=115200";
    return new Device() {
      @Override
      public ByteLink open() {
        return ByteLinks.open(address, new SystemClock());
      }

      @Override
      public void says(String text) {
        cable.device().says(text);
      }

      @Override
      public String wasTold() {
        return cable.device().wasTold();
      }

      @Override
      public void unplug() throws Exception {
        cable.unplug();
      }

      @Override
      public void plug() throws Exception {
        cable.plug();
      }

      /**
       * A UART has sent all when a write returns, but jSerialComm discards what waits in a pseudo
       * terminal when it closes it.
       */
      @Override
      public boolean hearsTheLast() {
        return false;
      }

      @Override
      public void end() throws Exception {
        cable.remove();
      }
    };
  }

  @Override
  String address() {
    return address;
  }
}
