package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import java.util.function.Supplier;
import org.u2sa.interfaces.BadInputException;

/** A connection by its address. */
record BoardAddress(String address, Supplier<IOIOConnection> maker) implements BoardConnection {
  private static final String SERIAL = "serial:";
  private static final String TCP = "tcp:";
  private static final int LAST_PORT = 65_535;

  static BoardConnection connection(String address) {
    if (address.startsWith(SERIAL) && address.length() > SERIAL.length()) {
      String port = address.substring(SERIAL.length());
      return new BoardAddress(address, () -> new SerialBoardConnection(port));
    }
    int colon = address.lastIndexOf(':');
    if (address.startsWith(TCP) && colon > TCP.length()) {
      String host = address.substring(TCP.length(), colon);
      int port = port(address, address.substring(colon + 1));
      return new BoardAddress(address, () -> new TcpBoardConnection(host, port));
    }
    throw new BadInputException(
        "IOIO: \"" + address + "\" is no address: serial:/dev/ttyACM0 or tcp:host:port expected");
  }

  private static int port(String address, String text) {
    try {
      int port = Integer.parseInt(text);
      if (port > 0 && port <= LAST_PORT) {
        return port;
      }
    } catch (NumberFormatException e) {
      throw new BadInputException("IOIO: \"" + address + "\": \"" + text + "\" is no port", e);
    }
    throw new BadInputException("IOIO: \"" + address + "\": port " + text + " is outside 1…65535");
  }

  @Override
  public IOIOConnection newConnection() {
    return maker.get();
  }
}
