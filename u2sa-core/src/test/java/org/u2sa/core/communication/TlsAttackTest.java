package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.security.GeneralSecurityException;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clients of the secured broker that keep its encryption busy and never log in. */
@Timeout(120)
class TlsAttackTest extends SecuredClients {
  private static final int MANY = 20_000;

  @ParameterizedTest
  @ValueSource(strings = {"TLSv1.2", "TLSv1.3"})
  void handshake_againAndAgain_endsTheConnection(String protocol)
      throws IOException, GeneralSecurityException {
    try (SSLSocket socket = (SSLSocket) TestAuthority.socket(directory)) {
      socket.setEnabledProtocols(new String[] {protocol});
      socket.connect(new InetSocketAddress("127.0.0.1", broker.port));
      socket.startHandshake();
      catchThrowable( // or not: in TLS 1.2 it may return on a closed connection
          () -> {
            for (int i = 0; i < MANY; i++) {
              socket.startHandshake();
            }
          });
    }
    awaitLog("connection closed, ", "TLS");
  }
}
