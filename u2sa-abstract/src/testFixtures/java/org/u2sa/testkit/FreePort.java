package org.u2sa.testkit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;

/**
 * A TCP port for the broker or the device of a test. It is below those that the system hands out by
 * itself: another process would get one of these as soon as it is released.
 */
public final class FreePort {
  private static final int LOWEST = 10_000;
  private static final int HIGHEST = 32_000;
  private static final int TRIALS = 100;

  private FreePort() {}

  /**
   * A port of the loopback address at which nobody listens now.
   *
   * @throws UncheckedIOException if there is none
   */
  public static int find() {
    IOException last = new IOException("no port tried");
    for (int i = 0; i < TRIALS; i++) {
      int port = ThreadLocalRandom.current().nextInt(LOWEST, HIGHEST);
      try (ServerSocket probe = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
        return probe.getLocalPort();
      } catch (IOException e) {
        last = e;
      }
    }
    throw new UncheckedIOException(last);
  }
}
