package org.u2sa.interfaces.mqtt;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import org.u2sa.interfaces.OneLine;

/**
 * TLS connections to devices that require a log-in, such as {@code ./u2sa board}: the client sends
 * {@code LOGIN user password}, the device answers {@code OK} or {@code REFUSED reason}.
 */
public final class SecuredSocket {
  private static final int LONGEST_ANSWER = 256;
  private static final String OK = "OK";

  private SecuredSocket() {}

  /**
   * Encrypts a connection, verifies the device's host name, and logs in. Reads wait as long as the
   * socket's time-out.
   *
   * @param access user and certificates
   * @param host host name that the certificate must contain
   * @throws IOException if the device is not the expected one, or rejects the user
   */
  public static Socket logIn(BrokerAccess access, Socket plain, String host, int port)
      throws IOException {
    SSLSocket socket =
        (SSLSocket) ((PromptTlsSockets) access.sockets()).createSocket(plain, host, port, true);
    SSLParameters parameters = socket.getSSLParameters();
    parameters.setEndpointIdentificationAlgorithm("HTTPS");
    socket.setSSLParameters(parameters);
    socket.startHandshake();
    String line = "LOGIN " + access.user().orElse("") + ' ' + new String(access.password()) + '\n';
    socket.getOutputStream().write(line.getBytes(StandardCharsets.UTF_8));
    socket.getOutputStream().flush();
    String answer = answer(socket.getInputStream());
    if (!answer.equals(OK)) {
      throw new IOException("unexpected answer to the log-in: \"" + OneLine.of(answer) + '"');
    }
    return socket;
  }

  private static String answer(InputStream in) throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int octet = in.read(); octet >= 0 && octet != '\n'; octet = in.read()) {
      if (line.size() < LONGEST_ANSWER) {
        line.write(octet);
      } else {
        throw new IOException("the answer to the log-in is too long");
      }
    }
    return new String(line.toByteArray(), StandardCharsets.UTF_8);
  }
}
