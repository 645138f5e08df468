package org.u2sa.flightgear.link;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;

/** A FlightGear of which the test decides every byte. */
final class RawFlightGear implements AutoCloseable {
  private static final int PATIENCE_MS = 5_000;

  private final ServerSocket controls = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
  private Socket lines;
  private Socket link;

  RawFlightGear() throws IOException {
    controls.setSoTimeout(PATIENCE_MS);
  }

  int inPort() {
    return controls.getLocalPort();
  }

  void connect(int outPort) throws IOException {
    lines = new Socket(InetAddress.getLoopbackAddress(), outPort);
    lines.setTcpNoDelay(true);
  }

  void send(String text) throws IOException {
    lines.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
    lines.getOutputStream().flush();
  }

  /** Whether the link closed the connection of our lines. */
  boolean isRefused() throws IOException {
    lines.setSoTimeout(PATIENCE_MS);
    return lines.getInputStream().read() < 0;
  }

  void closeLines() throws IOException {
    lines.close();
  }

  /** Waits for the link's connection for controls. */
  BufferedReader acceptControls() throws IOException {
    link = controls.accept();
    link.setSoTimeout(PATIENCE_MS);
    return new BufferedReader(
        new InputStreamReader(link.getInputStream(), StandardCharsets.US_ASCII));
  }

  void closeControls() throws IOException {
    link.close();
  }

  void stopListening() throws IOException {
    controls.close();
  }

  /** A good line, with its end. */
  static String line(double elapsedS, double headingRad) {
    Map<OutField, Double> values = new HashMap<>();
    values.put(OutField.ELAPSED, elapsedS);
    values.put(OutField.HEADING, headingRad);
    return OutLine.of(values).format() + "\n";
  }

  /** A good line of an aircraft whose engine is being started, with its end. */
  static String lineOfStartingEngine() {
    return OutLine.of(Map.of(OutField.ELAPSED, 1.0, OutField.PRIMER, 1.0)).format() + "\n";
  }

  @Override
  public void close() throws IOException {
    controls.close();
    if (lines != null) {
      lines.close();
    }
    if (link != null) {
      link.close();
    }
  }
}
