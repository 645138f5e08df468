package org.u2sa.sim.ioio;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Source of the hosts of a served board, one at a time. */
public interface Hosts extends Closeable {
  /**
   * An admitted host.
   *
   * @param name for the log
   * @param input bytes to the board; its read may throw {@link java.net.SocketTimeoutException} if
   *     the host is silent for too long
   * @param end closes both streams immediately; callable from any thread
   */
  record Host(String name, InputStream input, OutputStream output, Closeable end) {}

  /**
   * Waits for the next host.
   *
   * @throws IOException if none came, or after {@link #close}
   */
  Host next() throws IOException;

  /** Called when a host's session has ended. */
  default void ended(Host host, String why) {}

  /** Called when the board stops because the simulation behind its pins failed. */
  default void failed(RuntimeException why) {}
}
