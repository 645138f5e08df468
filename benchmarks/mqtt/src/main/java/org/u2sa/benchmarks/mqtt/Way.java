package org.u2sa.benchmarks.mqtt;

/** One half of a way from a sender to a listener, in this process; the other may be in another. */
interface Way extends AutoCloseable {
  /** Takes what arrives, on whatever thread the way has for it. */
  @FunctionalInterface
  interface Sink {
    /**
     * One message.
     *
     * @param sentNanos when it was sent, by {@link System#nanoTime}, which on Linux is the same for
     *     all processes of a machine
     */
    void arrived(long sentNanos);
  }

  /** Sends one message that carries this time. The listening half sends nothing. */
  void send(long sentNanos) throws Exception;

  @Override
  void close() throws Exception;
}
