package org.u2sa.interfaces.mqtt;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
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
   * Encrypts a connection, verifies the device's host name, and logs in. A device that sends a byte
   * now and then never exceeds the socket's time-out, so handshake and log-in share one time limit,
   * at which {@code plain} is closed.
   *
   * @param access user and certificates
   * @param host host name that the certificate must contain
   * @param withinMs time limit [ms], positive
   * @throws IOException if the device is not the expected one, rejects the user, or takes too long
   */
  public static Socket logIn(
      BrokerAccess access, Socket plain, String host, int port, long withinMs) throws IOException {
    CountDownLatch over = new CountDownLatch(1);
    AtomicBoolean overdue = new AtomicBoolean();
    Thread limit =
        new Thread(() -> closeUnless(over, plain, withinMs, overdue), "u2sa-login-time-limit");
    limit.setDaemon(true);
    limit.start();
    Socket loggedIn;
    try {
      loggedIn = logIn(access, plain, host, port);
    } catch (IOException | RuntimeException e) {
      if (overdue.get()) {
        throw tooSlow(withinMs, e);
      }
      throw e;
    } finally {
      over.countDown();
    }
    if (overdue.get()) { // just now
      throw tooSlow(withinMs, null);
    }
    return loggedIn;
  }

  private static IOException tooSlow(long withinMs, Exception cause) {
    return new IOException("the log-in took longer than " + withinMs + " ms", cause);
  }

  private static void closeUnless(
      CountDownLatch over, Socket plain, long withinMs, AtomicBoolean overdue) {
    try {
      if (!over.await(withinMs, TimeUnit.MILLISECONDS)) {
        overdue.set(true);
        plain.close();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      return; // closed in the meantime
    }
  }

  private static Socket logIn(BrokerAccess access, Socket plain, String host, int port)
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
