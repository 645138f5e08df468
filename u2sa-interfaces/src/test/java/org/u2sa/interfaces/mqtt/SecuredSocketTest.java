package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Log-ins at devices over TLS. */
@Timeout(60)
class SecuredSocketTest {
  private static final long WITHIN_MS = 500;
  private static final int READ_MS = 20_000;
  private static final byte[] HANDSHAKE = {
    22, 3, 3, 16, 0, 2, 0, 15, (byte) 252
  }; // 4 KiB announced
  private static final long BETWEEN_BYTES_NS = 50_000_000;

  /** Sends a handshake message byte by byte, each in time for the socket's time-out. */
  private static void drip(ServerSocket server) {
    try (Socket client = server.accept()) {
      OutputStream out = client.getOutputStream();
      out.write(HANDSHAKE);
      while (true) {
        out.write(0);
        LockSupport.parkNanos(BETWEEN_BYTES_NS);
      }
    } catch (IOException e) {
      return; // the client has gone
    }
  }

  @Test
  void logIn_deviceDripsBytes_endsAtTheTimeLimit() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Socket plain = new Socket(InetAddress.getLoopbackAddress(), server.getLocalPort())) {
      Thread device = new Thread(() -> drip(server), "dripping device");
      device.setDaemon(true);
      device.start();
      plain.setSoTimeout(READ_MS);
      BrokerAccess access = BrokerAccess.of("", "", true, "");

      assertThatThrownBy(
              () ->
                  SecuredSocket.logIn(access, plain, "127.0.0.1", server.getLocalPort(), WITHIN_MS))
          .isInstanceOf(IOException.class)
          .hasMessage("the log-in took longer than 500 ms");
    }
  }
}
