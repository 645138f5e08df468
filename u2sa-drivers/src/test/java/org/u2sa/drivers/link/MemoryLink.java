package org.u2sa.drivers.link;

import java.io.ByteArrayOutputStream;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * A link whose other end is the test or a simulated device: what a service writes is handed over at
 * once, so that runs in simulated time are the same each time. Safe for several threads.
 */
public final class MemoryLink implements ByteLink {
  /** What is at the other end. */
  @FunctionalInterface
  public interface Device {
    /** Takes what was written; answers by {@link MemoryLink#fromDevice}. */
    void accept(byte[] bytes);
  }

  private final Deque<Byte> toRead = new ArrayDeque<>();
  private final ByteArrayOutputStream written = new ByteArrayOutputStream();
  private Device device = bytes -> {};
  private Runnable producer = () -> {};
  private boolean connected = true;
  private int connections = 1;
  private int told = 1; // the number of the connection that the reader knows of
  private boolean closed;

  /** Puts a simulated device at the other end. */
  public synchronized MemoryLink with(Device newDevice) {
    device = newDevice;
    return this;
  }

  /** Called before each reading: a device that speaks by itself says what is due by now. */
  public synchronized MemoryLink producing(Runnable newProducer) {
    producer = newProducer;
    return this;
  }

  /** Lets the device say something. */
  public synchronized void fromDevice(byte... bytes) {
    if (connected) {
      for (byte each : bytes) {
        toRead.add(each);
      }
    }
  }

  /** All that was written so far; forgets it. */
  public synchronized byte[] written() {
    byte[] all = written.toByteArray();
    written.reset();
    return all;
  }

  /** Pulls the plug: what was under way is lost. */
  public synchronized void unplug() {
    connected = false;
    toRead.clear();
  }

  /** Puts the plug back. */
  public synchronized void plug() {
    if (!connected) {
      connected = true;
      connections++;
    }
  }

  /** Whether {@link #close} was called. */
  public synchronized boolean isClosed() {
    return closed;
  }

  @Override
  public synchronized int read(byte[] buffer) {
    if (told != connections) {
      told = connections;
      return 0;
    }
    producer.run();
    int count = 0;
    while (count < buffer.length && !toRead.isEmpty()) {
      buffer[count++] = toRead.remove();
    }
    return count;
  }

  @Override
  public synchronized boolean write(byte[] bytes) {
    if (!connected || closed) {
      return false;
    }
    written.writeBytes(bytes);
    device.accept(bytes.clone());
    return true;
  }

  @Override
  public synchronized boolean isConnected() {
    return connected && !closed;
  }

  @Override
  public synchronized int connections() {
    told = connections;
    return connections;
  }

  @Override
  public synchronized String trouble() {
    return closed ? "closed" : connected ? "" : "unplugged";
  }

  @Override
  public synchronized void close() {
    closed = true;
  }
}
