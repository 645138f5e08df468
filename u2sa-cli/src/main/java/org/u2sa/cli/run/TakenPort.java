package org.u2sa.cli.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.OptionalInt;

/** Finds another TCP port for a run's broker if the configured one is taken. */
public final class TakenPort {
  private TakenPort() {}

  /**
   * Returns a free port to use instead.
   *
   * @param address the broker will listen on
   * @return empty if the configured port is free
   */
  public static OptionalInt replacement(String address, int port) {
    return isTaken(address, port) ? OptionalInt.of(freePort()) : OptionalInt.empty();
  }

  private static boolean isTaken(String address, int port) {
    try (ServerSocket probe = new ServerSocket()) {
      probe.bind(new InetSocketAddress(address, port));
      return false;
    } catch (IOException | IllegalArgumentException e) {
      return true; // an invalid address is reported by the Communication Manager
    }
  }

  private static int freePort() {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    } catch (IOException e) {
      throw new UncheckedIOException("no free TCP port for the broker", e);
    }
  }
}
