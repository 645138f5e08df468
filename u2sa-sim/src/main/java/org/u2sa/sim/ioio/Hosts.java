package org.u2sa.sim.ioio;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Where the hosts of a served board come from, one after the other. */
public interface Hosts extends Closeable {
  /**
   * An admitted host.
   *
   * @param name for the log
   * @param input bytes to the board; its read may end with a {@link
   *     java.net.SocketTimeoutException} for a host that is silent too long
   * @param end ends both streams, at once and from any thread
   */
  record Host(String name, InputStream input, OutputStream output, Closeable end) {}

  /**
   * Waits for the next host.
   *
   * @throws IOException if none came, or after {@link #close}
   */
  Host next() throws IOException;

  /** A host's session has ended. */
  default void ended(Host host, String why) {}

  /** The board cannot go on: the simulation behind its pins failed. */
  default void failed(RuntimeException why) {}
}
