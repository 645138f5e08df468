package org.u2sa.sim.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.SystemClock;

class IoioTcpServerTest {
  private static final int PATIENCE_MS = 20_000;

  private final IoioTcpServer server =
      new IoioTcpServer(new IoioFirmware(IoioBoard.V1, new Pins() {}), new SystemClock(), 0);

  private Socket connect() throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    socket.setSoTimeout(PATIENCE_MS);
    return socket;
  }

  @Test
  void connect_oneHostAfterTheOther_eachIsGreetedAndAnswered() throws IOException {
    for (int round = 0; round < 3; round++) {
      try (Socket host = connect()) {
        InputStream in = host.getInputStream();
        byte[] greeting = in.readNBytes(29);
        assertThat(new String(greeting, 1, 28, StandardCharsets.US_ASCII))
            .isEqualTo("IOIOSPRK0016IOIO0312IOIO0506");
        host.getOutputStream().write(0x23);
        assertThat(in.read()).isEqualTo(0x23);
      }
    }
    server.close();
  }

  @Test
  void accept_wrongByte_hangsUp() throws IOException {
    try (Socket host = connect()) {
      host.getInputStream().readNBytes(29);
      host.getOutputStream().write(0xFF);
      assertThat(host.getInputStream().read()).isEqualTo(-1);
    }
    server.close();
  }

  @Test
  void accept_softClose_answersAndHangsUp() throws IOException {
    try (Socket host = connect()) {
      host.getInputStream().readNBytes(29);
      host.getOutputStream().write(0x1D);
      assertThat(host.getInputStream().read()).isEqualTo(0x1D);
      assertThat(host.getInputStream().read()).isEqualTo(-1);
    }
    server.close();
  }

  @Test
  void close_hostConnected_endsAllThreads() throws IOException {
    try (Socket host = connect()) {
      host.getInputStream().readNBytes(29);
      server.close();
      assertThat(host.getInputStream().read()).isEqualTo(-1);
    }
    assertThat(Thread.getAllStackTraces().keySet())
        .extracting(Thread::getName)
        .noneMatch(name -> name.startsWith("u2sa-ioio-server"));
  }
}
