package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLEngineResult.HandshakeStatus;
import org.u2sa.interfaces.time.Clock;

/**
 * A {@link BrokerChannel} with TLS, which never blocks after its handshake. Sends no close_notify,
 * because MQTT has its own end-of-session message.
 */
final class TlsChannel implements BrokerChannel {
  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  private final SocketChannel socket;
  private final SSLEngine engine;
  private ByteBuffer received; // encrypted, not yet complete; in write mode, as the others
  private ByteBuffer plain; // decrypted, not yet read
  private ByteBuffer sending; // encrypted, not yet accepted by the network
  private boolean unread;
  private volatile boolean owesAnswer; // to a TLS message, such as a key update

  /**
   * @param socket connected and non-blocking
   * @param engine in client mode, not used before
   */
  TlsChannel(SocketChannel socket, SSLEngine engine) {
    this.socket = socket;
    this.engine = engine;
    received = ByteBuffer.allocate(engine.getSession().getPacketBufferSize());
    plain = ByteBuffer.allocate(engine.getSession().getApplicationBufferSize());
    sending = ByteBuffer.allocate(engine.getSession().getPacketBufferSize());
  }

  /**
   * Performs the handshake, before the first read and write.
   *
   * @param selector announces when the socket is readable
   * @throws IOException if the certificate is not trusted or belongs to another host, no protocol
   *     is common to both, the broker does not answer in time, or the connection breaks
   */
  void shakeHands(Selector selector, Clock clock, long withinMs) throws IOException {
    long deadline = clock.micros() + TimeUnit.MILLISECONDS.toMicros(withinMs);
    engine.beginHandshake();
    while (owesAnswer || engine.getHandshakeStatus() != HandshakeStatus.NOT_HANDSHAKING) {
      switch (engine.getHandshakeStatus()) {
        case NEED_UNWRAP -> {
          if (!decrypt()) {
            awaitMore(selector, clock, deadline);
          }
        }
        case NEED_TASK -> compute();
        default -> {
          owesAnswer = true;
          write(NOTHING);
        }
      }
    }
  }

  private void awaitMore(Selector selector, Clock clock, long deadline) throws IOException {
    long leftMs = TimeUnit.MICROSECONDS.toMillis(deadline - clock.micros());
    if (leftMs <= 0) {
      throw new SocketTimeoutException("the broker does not answer the TLS handshake");
    }
    selector.select(leftMs);
    selector.selectedKeys().clear();
    write(NOTHING); // data that the network has not accepted yet
    if (socket.read(received) < 0) {
      throw new IOException("the broker ended the connection during the TLS handshake");
    }
  }

  @Override
  public int read(ByteBuffer to) throws IOException {
    int before = to.position();
    boolean ended = socket.read(received) < 0;
    move(to);
    while (to.hasRemaining() && decrypt()) {
      move(to);
    }
    unread = !to.hasRemaining();
    int read = to.position() - before;
    return read == 0 && !unread && (ended || engine.isInboundDone()) ? -1 : read;
  }

  private void move(ByteBuffer to) {
    MqttPackets.flip(plain);
    int count = Math.min(plain.remaining(), to.remaining());
    to.put(plain.array(), 0, count);
    MqttPackets.position(plain, count);
    plain.compact();
  }

  /** Decrypts one record; returns false if that needs more from the broker. */
  private boolean decrypt() throws IOException {
    MqttPackets.flip(received);
    SSLEngineResult result;
    try {
      result = engine.unwrap(received, plain);
    } finally {
      received.compact();
    }
    switch (result.getStatus()) {
      case BUFFER_UNDERFLOW -> {
        received = withRoom(received, engine.getSession().getPacketBufferSize());
        return false;
      }
      case BUFFER_OVERFLOW -> {
        plain = withRoom(plain, plain.position() + engine.getSession().getApplicationBufferSize());
        return true;
      }
      case CLOSED -> {
        return false;
      }
      default -> {
        boolean goesOn = result.bytesConsumed() > 0;
        if (result.getHandshakeStatus() == HandshakeStatus.NEED_TASK) {
          compute();
          goesOn = true;
        }
        noteAnswerOwed();
        return goesOn;
      }
    }
  }

  private void compute() {
    for (Runnable task = engine.getDelegatedTask(); task != null; ) {
      task.run();
      task = engine.getDelegatedTask();
    }
  }

  private static ByteBuffer withRoom(ByteBuffer buffer, int capacity) {
    if (buffer.capacity() >= capacity) {
      return buffer;
    }
    ByteBuffer larger = ByteBuffer.allocate(capacity);
    MqttPackets.flip(buffer);
    return larger.put(buffer);
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    int before = from.position();
    boolean goesOn = sent();
    while (goesOn && (from.hasRemaining() || owesAnswer)) {
      owesAnswer = false;
      goesOn = encrypt(from) && sent();
    }
    return from.position() - before;
  }

  /** Encrypts one record; returns false if the engine first needs something from the broker. */
  private boolean encrypt(ByteBuffer from) throws IOException {
    sending = withRoom(sending, engine.getSession().getPacketBufferSize());
    SSLEngineResult result = engine.wrap(from, sending);
    if (result.getStatus() == SSLEngineResult.Status.CLOSED) {
      throw new IOException("the broker ended the encryption");
    }
    noteAnswerOwed();
    return result.bytesProduced() > 0;
  }

  private void noteAnswerOwed() {
    if (engine.getHandshakeStatus() == HandshakeStatus.NEED_WRAP) {
      owesAnswer = true;
    }
  }

  /** Sends the encrypted data; returns whether the network has accepted all of it. */
  private boolean sent() throws IOException {
    MqttPackets.flip(sending);
    try {
      socket.write(sending);
      return !sending.hasRemaining();
    } finally {
      sending.compact();
    }
  }

  @Override
  public boolean hasUnread() {
    return unread;
  }

  @Override
  public boolean hasUnsent() {
    return owesAnswer || sending.position() > 0;
  }

  @Override
  public boolean isOpen() {
    return socket.isOpen();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
