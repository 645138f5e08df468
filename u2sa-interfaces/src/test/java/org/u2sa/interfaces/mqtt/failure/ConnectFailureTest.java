package org.u2sa.interfaces.mqtt.failure;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.EOFException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;
import java.security.cert.CertPathValidatorException;
import java.security.cert.CertificateExpiredException;
import java.time.Instant;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLHandshakeException;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.CommunicationException;

/** What an operator is told to do; failures of a real broker are in SecuredLoginTest of core. */
class ConnectFailureTest {
  private static final Instant NOW = Instant.parse("2031-02-03T04:05:06Z");

  private static String text(String address, String user, MqttException failure) {
    return new ConnectFailure(address, user, NOW).text(failure, "reason");
  }

  private static MqttException unreachable(Throwable cause) {
    return new MqttException(MqttException.REASON_CODE_SERVER_CONNECT_ERROR, cause);
  }

  @Test
  void text_brokerIsAbsent_asksWhetherItRuns() {
    assertThat(text("tcp://localhost:1", "", unreachable(new IOException("Connection refused"))))
        .isEqualTo(
            "no Communication Manager at tcp://localhost:1: reason; is it running, and is the address right?");
  }

  @Test
  void text_certificateIsExpired_saysThisMachinesTime() {
    SSLHandshakeException refused = new SSLHandshakeException("PKIX path validation failed");
    refused.initCause(
        new CertPathValidatorException(
            "validity check failed", new CertificateExpiredException("NotAfter: yesterday")));

    assertThat(text("ssl://localhost:1", "ann", unreachable(refused)))
        .startsWith("cannot join the Communication Manager at ssl://localhost:1: reason; ")
        .contains("this machine's clock says 2031-02-03T04:05:06Z; set the clock, or renew");
  }

  @Test
  void text_plainBrokerAskedForTls_saysWhatToLeaveOut() {
    assertThat(text("ssl://localhost:1", "", unreachable(new SSLException("Unsupported message"))))
        .endsWith("is it encrypted? Without TLS, leave out --ca or CA FILE");
  }

  @Test
  void text_userOfAnotherSystem_namesTheUser() {
    assertThat(
            text(
                "ssl://localhost:1",
                "ann",
                new MqttException(MqttException.REASON_CODE_NOT_AUTHORIZED)))
        .endsWith("user \"ann\" may not join this system; ./u2sa security user list tells whose");
  }

  @Test
  void encryptedPort_portThatEndsConnections_isNot() throws Exception {
    try (ServerSocket plain = new ServerSocket(0)) {
      Thread ending =
          new Thread(
              () -> {
                try {
                  plain.accept().close();
                } catch (IOException e) {
                  return; // the test is over
                }
              });
      ending.start();
      assertThat(EncryptedPort.is("localhost", plain.getLocalPort())).isFalse();
      ending.join();
    }
    assertThat(EncryptedPort.is("localhost", 1)).isFalse();
  }

  @Test
  void isPassing_silentOrEndingBroker_isWorthAnotherAttempt() {
    assertThat(isPassing(MqttException.REASON_CODE_CLIENT_TIMEOUT, null)).isTrue();
    assertThat(isPassing(MqttException.REASON_CODE_CONNECTION_LOST, new EOFException())).isTrue();
    assertThat(isPassing(0, new SocketTimeoutException("no TLS handshake"))).isTrue();
  }

  @Test
  void isPassing_nobodyThereOrRefused_isNot() {
    assertThat(isPassing(0, new ConnectException("refused"))).isFalse();
    assertThat(isPassing(MqttException.REASON_CODE_NOT_AUTHORIZED, null)).isFalse();
    assertThat(isPassing(MqttException.REASON_CODE_CONNECTION_LOST, new SSLException("no TLS")))
        .isFalse();
    assertThat(ConnectFailure.isPassing(new IllegalStateException())).isFalse();
  }

  private static boolean isPassing(int code, Throwable cause) {
    return ConnectFailure.isPassing(new CommunicationException("", new MqttException(code, cause)));
  }
}
