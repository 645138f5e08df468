package org.u2sa.drivers.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.util.Arrays;

/**
 * Opens desktop serial ports with jSerialComm; with {@link SerialLibrary} the only class that uses
 * it, loaded only for {@code serial:} addresses because Android has no such ports.
 */
final class SerialOpener implements Port.Opener {
  private static final int DATA_BITS = 8;

  private static final int USUAL_BAUD = 9_600;
  private static final int FASTEST_BAUD = 4_000_000;

  private final String path;
  private final int baud;
  private final int parity;
  private final int stopBits;
  private final boolean dtr;
  private final boolean raisesDtr;

  /**
   * @param raisesDtr whether the device waits for a rising DTR, which may already be high
   * @throws org.u2sa.interfaces.BadInputException if an option is invalid
   */
  SerialOpener(LinkAddress address, boolean raisesDtr) {
    this.raisesDtr = raisesDtr;
    path = address.target();
    baud = address.option("baud", USUAL_BAUD, 1, FASTEST_BAUD);
    parity = parityOf(address);
    stopBits = address.option("stop", 1, 1, 2);
    dtr = address.flag("dtr", true);
  }

  @Override
  public Port open() throws IOException {
    try {
      SerialLibrary.load();
      SerialPort port = SerialPort.getCommPort(path);
      port.setComPortParameters(
          baud,
          DATA_BITS,
          stopBits == 1 ? SerialPort.ONE_STOP_BIT : SerialPort.TWO_STOP_BITS,
          parity);
      port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
      port.setComPortTimeouts(
          SerialPort.TIMEOUT_READ_SEMI_BLOCKING | SerialPort.TIMEOUT_WRITE_BLOCKING,
          Port.PATIENCE_MS,
          0);
      if (!port.openPort(0)) {
        throw new IOException(
            path + " cannot be opened (" + errorText(port.getLastErrorCode()) + ")");
      }
      if (!dtr || raisesDtr) {
        port.clearDTR();
      }
      if (raisesDtr) {
        port.setDTR();
      }
      return new Opened(path, port);
    } catch (SerialPortInvalidPortException e) {
      throw new IOException(path + " does not exist", e);
    } catch (LinkageError e) { // no native library on phones: UnsatisfiedLinkError first, then
      // NoClassDefFoundError
      throw new IOException("no serial ports on this platform: " + e.getMessage(), e);
    }
  }

  private static int parityOf(LinkAddress address) {
    String parity = address.option("parity");
    return switch (parity) {
      case "", "none" -> SerialPort.NO_PARITY;
      case "even" -> SerialPort.EVEN_PARITY;
      case "odd" -> SerialPort.ODD_PARITY;
      default ->
          throw address.refused("option \"parity\": \"" + parity + "\" is not none, even or odd");
    };
  }

  /** Messages for the errno(3) values users encounter. */
  private static String errorText(int code) {
    return switch (code) {
      case 2 -> "not found";
      case 13 -> "permission denied: is the user in the group dialout?";
      case 16 -> "another program is using it";
      default -> "error " + code;
    };
  }

  private static final class Opened implements Port {
    private final String path;
    private final SerialPort port;

    Opened(String path, SerialPort port) {
      this.path = path;
      this.port = port;
    }

    @Override
    public int read(byte[] buffer) throws IOException {
      int count = port.readBytes(buffer, buffer.length);
      if (count < 0) {
        throw new IOException(path + " was unplugged");
      }
      return count;
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      byte[] rest = bytes;
      while (rest.length > 0) {
        int count = port.writeBytes(rest, rest.length);
        if (count <= 0) {
          throw new IOException(path + " was unplugged");
        }
        rest = Arrays.copyOfRange(rest, count, rest.length);
      }
    }

    @Override
    public void close() {
      port.closePort();
    }
  }
}
