package org.u2sa.flightgear.link;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/** FlightGear's property server, as much as a repair needs. Calls block, at most some seconds. */
final class PropertyServer implements AutoCloseable {
  private static final int PATIENCE_MS = 3_000;
  private static final int MAX_LINES = 50;
  private static final int MAX_CHARS = 4_096; // per line; answers have some hundred

  private final Socket socket = new Socket();
  private final BufferedReader in;
  private final OutputStream out;
  private final Clock stopwatch = new SystemClock(); // sockets time out in real time

  /**
   * @throws IOException if nobody answers
   */
  PropertyServer(String host, int port) throws IOException {
    try {
      socket.connect(new InetSocketAddress(host, port), PATIENCE_MS);
      socket.setSoTimeout(PATIENCE_MS);
      in =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
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
    long untilMicros = say("get " + path);
    for (int i = 0; i < MAX_LINES; i++) {
      String answer = hear("get " + path, untilMicros);
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
    long untilMicros = say("run " + command);
    for (int i = 0; i < MAX_LINES; i++) {
      String answer = hear("run " + command, untilMicros);
      if (answer.contains("<completed>")) {
        return true;
      }
      if (answer.contains("failed")) {
        return false;
      }
    }
    throw new IOException("property server did not answer \"run " + command + "\"");
  }

  /** Returns until when to wait for the answer [µs of the stopwatch]. */
  private long say(String line) throws IOException {
    out.write((line + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
    out.flush();
    return stopwatch.micros() + 1_000L * PATIENCE_MS;
  }

  private String hear(String asked, long untilMicros) throws IOException {
    StringBuilder answer = new StringBuilder();
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        throw new IOException("property server closed after \"" + asked + "\"");
      }
      if (answer.length() == MAX_CHARS) {
        throw new IOException(
            String.format(
                "property server answered \"%s\" by a line of more than %d characters",
                asked, MAX_CHARS));
      }
      if (stopwatch.micros() > untilMicros) { // a byte now and then is no answer
        throw new IOException("property server did not answer \"" + asked + "\" in time");
      }
      answer.append((char) next);
    }
    return answer.toString();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
