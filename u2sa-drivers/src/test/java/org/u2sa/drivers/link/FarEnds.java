package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.nio.file.Path;
import org.u2sa.interfaces.time.SystemClock;

/** The devices that links are tested with, one for each kind of link. */
public final class FarEnds {
  private FarEnds() {}

  /** In the same process. */
  public static FarEnd memory() {
    return new Memory();
  }

  /** In the same process, and recorded in that file. */
  public static FarEnd recorded(Path file) {
    return new Memory() {
      @Override
      public ByteLink open() {
        return new RecordingLink(super.open(), file, new SystemClock());
      }
    };
  }

  /** Behind a TCP server. */
  public static FarEnd tcp() throws IOException {
    MemoryLink device = new MemoryLink();
    DeviceServer server = new DeviceServer(device);
    return new Far(device, server.address()) {
      @Override
      public void unplug() throws Exception {
        super.unplug();
        server.unplug();
      }

      @Override
      public void plug() throws Exception {
        super.plug();
        server.plug();
      }

      @Override
      public void end() throws IOException {
        server.close();
      }
    };
  }

  /** On a serial line, which is a pseudo terminal here. Skips the test where there is no socat. */
  public static FarEnd serial(Path path) throws IOException {
    MemoryLink device = new MemoryLink();
    DeviceServer server = new DeviceServer(device);
    SerialCable cable = SerialCable.required(path, server.address());
    return new Far(device, "serial:" + cable.path() + "?baud=115200") {
      @Override
      public void unplug() throws Exception {
        super.unplug();
        cable.unplug();
      }

      @Override
      public void plug() throws Exception {
        super.plug();
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
        cable.unplug();
        server.close();
      }
    };
  }

  /** One that answers datagrams. */
  public static FarEnd udp() throws IOException {
    return new DatagramDevice();
  }

  /** A device in this process, behind an address or none. */
  private static class Far implements FarEnd {
    private final MemoryLink link;
    private final String address;
    private final StringBuffer told = new StringBuffer();

    Far(MemoryLink link, String address) {
      this.link = link.with(bytes -> told.append(new String(bytes, US_ASCII)));
      this.address = address;
    }

    @Override
    public String address() {
      return address;
    }

    @Override
    public ByteLink open() {
      return ByteLinks.open(address, new SystemClock());
    }

    @Override
    public void says(String text) {
      link.fromDevice(text.getBytes(US_ASCII));
    }

    @Override
    public String wasTold() {
      return told.toString();
    }

    @Override
    public void unplug() throws Exception {
      link.unplug();
    }

    @Override
    public void plug() throws Exception {
      link.plug();
    }

    @Override
    public void end() throws Exception {
      link.close();
    }
  }

  private static class Memory extends Far {
    private final MemoryLink link;

    Memory() {
      this(new MemoryLink());
    }

    private Memory(MemoryLink link) {
      super(link, " no thread");
      this.link = link;
    }

    @Override
    public ByteLink open() {
      return link;
    }
  }
}
