package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.net.InetAddress;
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
    SocketDevice server = new SocketDevice(InetAddress.getLoopbackAddress());
    return new Socketed("tcp:127.0.0.1:" + server.port(), server);
  }

  /** On a serial line, which is a pseudo terminal here. Skips the test where there is no socat. */
  public static FarEnd serial(Path path) throws IOException {
    SerialCable cable = SerialCable.required(path);
    return new Socketed("serial:" + cable.path() + "?baud=115200", cable.device()) {
      @Override
      public void unplug() throws InterruptedException {
        cable.unplug();
      }

      @Override
      public void plug() throws IOException {
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

  /** One that answers datagrams. */
  public static FarEnd udp() throws IOException {
    return new DatagramDevice();
  }

  private static class Memory implements FarEnd {
    private final MemoryLink link = new MemoryLink();
    private final StringBuilder told = new StringBuilder();

    @Override
    public String address() {
      return " no thread";
    }

    @Override
    public ByteLink open() {
      return link.with(bytes -> told.append(new String(bytes, US_ASCII)));
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
    public void unplug() {
      link.unplug();
    }

    @Override
    public void plug() {
      link.plug();
    }

    @Override
    public void end() {
      link.close();
    }
  }

  private static class Socketed implements FarEnd {
    private final String address;
    private final SocketDevice server;

    Socketed(String address, SocketDevice server) {
      this.address = address;
      this.server = server;
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
      server.says(text);
    }

    @Override
    public String wasTold() {
      return server.wasTold();
    }

    @Override
    public void unplug() throws Exception {
      server.unplug();
    }

    @Override
    public void plug() throws IOException {
      server.plug();
    }

    @Override
    public void end() throws Exception {
      server.unplug();
    }
  }
}
