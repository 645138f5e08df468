package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.io.OutputStream;

/**
 * Has the IOIO library send what is written to one UART, in lockstep, on the thread that writes.
 * The library sends on a thread of its own for each UART, at a moment of its own; to wake that and
 * to wait for it takes far longer than the sending.
 *
 * <p>That thread sends once, and is then ended by an interrupt. From then on the writing thread
 * runs the library's loop ({@code FlowControlledOutputStream.FlushThread.run}), and leaves it by an
 * error when all is sent ({@link FlushCounter#run}). Its interrupt flag is set meanwhile: should
 * the loop wait for the board before, it returns there. Belongs to the service's thread.
 */
final class SendingLoop {
  private Thread owner; // the library's, ended; null before the first time

  /**
   * Writes bytes to a UART and returns when they are sent.
   *
   * @param sent counts what the library sends
   */
  void send(OutputStream uart, byte[] bytes, int count, FlushCounter sent) throws IOException {
    sent.expect(count);
    uart.write(bytes, 0, count);
    boolean wasInterrupted = Thread.interrupted();
    try {
      if (owner == null) {
        owner = end(sent.awaitSender());
      } else {
        Thread.currentThread().interrupt();
        sent.run(owner);
      }
      sent.requireAll();
    } catch (InterruptedException e) {
      wasInterrupted = true;
    } finally {
      Thread.interrupted();
      if (wasInterrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private static Thread end(Thread sender) throws InterruptedException {
    sender.interrupt(); // nothing is left for it to send, so it is about to wait
    sender.join();
    return sender;
  }
}
