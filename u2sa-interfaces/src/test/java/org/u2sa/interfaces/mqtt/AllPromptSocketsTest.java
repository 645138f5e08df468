package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.List;
import javax.net.SocketFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.SSLSocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Every way to make a socket makes one that sends small packets at once. */
class AllPromptSocketsTest {
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();

  private ServerSocket server;
  private int port;

  @BeforeEach
  void listen() throws IOException {
    server = new ServerSocket(0, 20, HERE);
    port = server.getLocalPort();
  }

  @AfterEach
  void close() throws IOException {
    server.close();
  }

  private List<Socket> ofEachWay(SocketFactory sockets) throws IOException {
    return List.of(
        sockets.createSocket(),
        sockets.createSocket(HERE, port),
        sockets.createSocket(HERE, port, HERE, 0),
        sockets.createSocket(HERE.getHostAddress(), port),
        sockets.createSocket(HERE.getHostAddress(), port, HERE, 0));
  }

  @Test
  void createSocket_plain_isPromptWhicheverWay() throws IOException {
    for (Socket each : ofEachWay(new PromptSockets())) {
      try (Socket socket = each) {
        assertThat(socket.getTcpNoDelay()).isTrue();
      }
    }
  }

  @Test
  void createSocket_encrypted_isPromptAndSpeaksNewProtocolsOnlyWhicheverWay()
      throws IOException, NoSuchAlgorithmException {
    SSLSocketFactory java = SSLContext.getDefault().getSocketFactory();
    PromptTlsSockets sockets = new PromptTlsSockets(SSLContext.getDefault());
    List<Socket> made = new ArrayList<>(ofEachWay(sockets));
    made.add(sockets.createSocket(new Socket(HERE, port), "broker", port, true));
    for (Socket each : made) {
      try (SSLSocket socket = (SSLSocket) each) {
        assertThat(socket.getTcpNoDelay()).isTrue();
        assertThat(socket.getEnabledProtocols()).containsExactlyInAnyOrder("TLSv1.2", "TLSv1.3");
      }
    }
    assertThat(sockets.getDefaultCipherSuites()).isEqualTo(java.getDefaultCipherSuites());
    assertThat(sockets.getSupportedCipherSuites()).isEqualTo(java.getSupportedCipherSuites());
  }

  @Test
  void engine_anyHost_speaksNewProtocolsOnlyAndVerifiesTheHost() throws NoSuchAlgorithmException {
    SSLEngine engine = new PromptTlsSockets(SSLContext.getDefault()).engine("broker", port);
    assertThat(engine.getEnabledProtocols()).containsExactlyInAnyOrder("TLSv1.2", "TLSv1.3");
    assertThat(engine.getUseClientMode()).isTrue();
    assertThat(engine.getPeerHost()).isEqualTo("broker");
    assertThat(engine.getSSLParameters().getEndpointIdentificationAlgorithm()).isEqualTo("HTTPS");
  }
}
