package org.u2sa.sim.sensor;

import java.util.ArrayDeque;
import org.u2sa.sim.motion.Arguments;

/**
 * A device's transmit line: bytes leave serially at the line rate (8N1). A message that does not
 * fit into the device's buffer is dropped whole.
 */
public final class UartTransmitter {
  private static final long BITS_A_BYTE = 10;
  private static final long NS_PER_S = 1_000_000_000L;
  private static final long NS_PER_US = 1_000L;

  private final int capacity;
  private final ArrayDeque<Message> messages = new ArrayDeque<>();
  private long byteNs;
  private int baud;
  private long freeAtNs;
  private long dropped;

  /**
   * @param baud the line's rate [bit/s], above 0
   * @param capacity capacity of the device's buffer [bytes], above 0
   */
  public UartTransmitter(int baud, int capacity) {
    Arguments.requireInside("transmit buffer", capacity, 1, 1 << 20);
    this.capacity = capacity;
    baud(baud);
  }

  /** Changes the line rate for subsequent messages. */
  public void baud(int newBaud) {
    Arguments.requireInside("baud rate", newBaud, 300, 10_000_000);
    baud = newBaud;
    byteNs = BITS_A_BYTE * NS_PER_S / newBaud;
  }

  /** The line's rate [bit/s]. */
  public int baud() {
    return baud;
  }

  /** Number of messages dropped so far. */
  public long dropped() {
    return dropped;
  }

  /**
   * Starts sending a message, or queues it.
   *
   * @param micros time [µs], non-decreasing
   */
  public void send(long micros, byte[] message) {
    long nowNs = micros * NS_PER_US;
    long waiting = Math.max(0L, freeAtNs - nowNs) / byteNs;
    if (waiting + message.length > capacity) {
      dropped++;
      return;
    }
    long startNs = Math.max(freeAtNs, nowNs);
    messages.add(new Message(message.clone(), startNs, byteNs, baud));
    freeAtNs = startNs + message.length * byteNs;
  }

  /**
   * Reads the bytes that have fully arrived at the other end.
   *
   * @param listeningBaud the receiver's rate; bytes at a different rate are lost
   * @return number of bytes read; call again if the buffer was filled
   */
  public int take(long micros, int listeningBaud, byte[] buffer) {
    long nowNs = micros * NS_PER_US;
    int count = 0;
    while (count < buffer.length && !messages.isEmpty() && messages.peek().arrived(nowNs)) {
      Message message = messages.peek();
      byte next = message.next();
      if (message.baud == listeningBaud) {
        buffer[count++] = next;
      }
      if (message.empty()) {
        messages.remove();
      }
    }
    return count;
  }

  /** Discards bytes that arrived before this time without a listener. */
  public void forget(long micros) {
    long beforeNs = micros * NS_PER_US - 1;
    while (!messages.isEmpty() && messages.peek().arrived(beforeNs)) {
      messages.peek().next();
      if (messages.peek().empty()) {
        messages.remove();
      }
    }
  }

  private static final class Message {
    private final byte[] bytes;
    private final long byteNs;
    private final int baud;
    private long nextNs; // arrival time of the next byte
    private int at;

    Message(byte[] bytes, long startNs, long byteNs, int baud) {
      this.bytes = bytes;
      this.byteNs = byteNs;
      this.baud = baud;
      this.nextNs = startNs + byteNs;
    }

    boolean arrived(long nowNs) {
      return nextNs <= nowNs;
    }

    byte next() {
      nextNs += byteNs;
      return bytes[at++];
    }

    boolean empty() {
      return at == bytes.length;
    }
  }
}
