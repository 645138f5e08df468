package org.u2sa.benchmarks.mqtt;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/** From one thread to another through a queue: what waking a thread takes. */
final class HandOff implements Way {
  private static final int CAPACITY = 1_024;

  private final BlockingQueue<Long> queue = new ArrayBlockingQueue<>(CAPACITY);
  private final Thread reader;

  HandOff(Sink sink) {
    reader =
        new Thread(
            () -> {
              try {
                while (true) {
                  sink.arrived(queue.take());
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt(); // closed
              }
            },
            "handoff");
    reader.setDaemon(true);
    reader.start();
  }

  @Override
  public void send(long sentNanos) throws InterruptedException {
    queue.put(sentNanos);
  }

  @Override
  public void close() {
    reader.interrupt();
  }
}
