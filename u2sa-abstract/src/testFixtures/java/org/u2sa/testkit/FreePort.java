package org.u2sa.testkit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;

/** A TCP port for the broker or the device of a test. */
public final class FreePort {
  private FreePort() {}

  /**
   * A port of the loopback address at which nobody listens now.
   *
   * @throws UncheckedIOException if there is none
   */
  public static int find() {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return probe.getLocalPort();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
