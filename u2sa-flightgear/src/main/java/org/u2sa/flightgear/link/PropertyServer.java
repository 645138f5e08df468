package org.u2sa.flightgear.link;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Client of FlightGear's property server, for repairs. Calls block for at most a few seconds and
 * read a limited number of bytes, because another program may use the port.
 */
final class PropertyServer implements AutoCloseable {
  private static final int PATIENCE_MS = 3_000;
  private static final int MAX_LINES = 50;
  private static final int MAX_LINE_BYTES = 4_096;

  private final Socket socket = new Socket();
  private final InputStream in;
  private final OutputStream out;
  private final Clock stopwatch = new SystemClock();
  private long untilMicros; // end of the current call

  /**
   * @throws IOException if there is no answer
   */
  PropertyServer(String host, int port) throws IOException {
    try {
      socket.connect(new InetSocketAddress(host, port), PATIENCE_MS);
      socket.setSoTimeout(PATIENCE_MS);
      in = new BufferedInputStream(socket.getInputStream());
      out = socket.getOutputStream();
    } catch (IOException e) {
      socket.close();
      throw new IOException("property server " + host + ":" + port + ": " + e.getMessage(), e);
    }
  }

  /** Local address at which FlightGear can reach this program. */
  String ownAddress() {
    return socket.getLocalAddress().getHostAddress();
  }

  /**
   * Returns the value of a property; empty if unset.
   *
   * @throws IOException if FlightGear does not answer
   */
  String get(String path) throws IOException {
    say("get " + path);
    for (int i = 0; i < MAX_LINES; i++) {
      String answer = hear("get " + path);
      int at = answer.indexOf(path + " = '");
      if (at >= 0) {
        String value = answer.substring(at + path.length() + " = '".length());
        return value.substring(0, Math.max(0, value.lastIndexOf('\'')));
      }
    }
    throw new IOException("property server did not answer \"get " + path + "\"");
  }

  /**
   * Runs a FlightGear command.
   *
   * @return whether FlightGear reports success
   * @throws IOException if FlightGear does not answer
   */
  boolean run(String command) throws IOException {
    say("run " + command);
    for (int i = 0; i < MAX_LINES; i++) {
      String answer = hear("run " + command);
      if (answer.contains("<completed>")) {
        return true;
      }
      if (answer.contains("failed")) {
        return false;
      }
    }
    throw new IOException("property server did not answer \"run " + command + "\"");
  }

  private void say(String line) throws IOException {
    untilMicros = stopwatch.micros() + PATIENCE_MS * Clock.MICROS_PER_SECOND / 1_000;
    out.write((line + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
    out.flush();
  }

  private String hear(String asked) throws IOException {
    StringBuilder answer = new StringBuilder();
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        throw new IOException("property server closed after \"" + asked + "\"");
      }
      if (answer.length() == MAX_LINE_BYTES) {
        throw new IOException(
            "property server: \""
                + asked
                + "\" has an answer longer than "
                + MAX_LINE_BYTES
                + " bytes");
      }
      if (stopwatch.micros() > untilMicros) {
        throw new IOException("property server did not answer \"" + asked + "\" in time");
      }
      answer.append((char) next); // ISO 8859-1
    }
    return answer.toString();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
