package org.u2sa.interfaces.mqtt.failure;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.security.GeneralSecurityException;
import java.security.cert.CertPathBuilderException;
import java.security.cert.CertificateException;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;

/** Whether a port speaks TLS. Nothing is sent but the beginning of a handshake. */
final class EncryptedPort {
  private static final int WITHIN_MS = 1_000;

  private EncryptedPort() {}

  static boolean is(String host, int port) {
    try (Socket plain = new Socket()) {
      plain.connect(new InetSocketAddress(host, port), WITHIN_MS);
      plain.setSoTimeout(WITHIN_MS);
      ((SSLSocket)
              SSLContext.getDefault().getSocketFactory().createSocket(plain, host, port, false))
          .startHandshake();
      return true;
    } catch (IOException e) { // a certificate, even one that is not trusted, is that of TLS
      return ConnectFailure.find(e, CertificateException.class).isPresent()
          || ConnectFailure.find(e, CertPathBuilderException.class).isPresent();
    } catch (GeneralSecurityException | IllegalArgumentException e) {
      return false; // it remains unknown
    }
  }
}
