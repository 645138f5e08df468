package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.io.OutputStream;

/**
 * In lockstep, lets the IOIO library send a UART's data on the writing thread. The library uses one
 * asynchronous sender thread per UART, and waking and awaiting it costs far more than the sending.
 *
 * <p>That thread sends once and is then ended by an interrupt. Afterwards the writing thread runs
 * the library's loop ({@code FlowControlledOutputStream.FlushThread.run}) and exits it by an error
 * once all is sent ({@link FlushCounter#run}). Its interrupt flag is set meanwhile, so a wait for
 * the board returns immediately. Confined to the service's thread.
 */
final class SendingLoop {
  private Thread owner; // the library's ended thread; null before first use

  /**
   * Writes bytes to a UART and returns once they are sent.
   *
   * @param sent counter of the library's output
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
    sender.interrupt(); // it has nothing left to send and is about to wait
    sender.join();
    return sender;
  }
}
