package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.time.Clock;

/**
 * An MQTT session by our own client: messages are sent on the publisher's thread and received on
 * one reader thread, two hand-offs fewer than with Paho. Publishing never blocks on the network:
 * the reader thread sends later what the socket does not accept.
 */
final class DirectSession implements MqttSession {
  private static final int REFUSED = 0x80; // failure code in a SUBACK
  private static final long FAREWELL_WITHIN_MS = 1_000;
  private static final int PINGREQ = 0xc0;
  private static final int DISCONNECT = 0xe0;

  private final String address;
  private final String clientId;
  private final Owner owner;
  private final long answerWithinMs;
  private final Clock clock;
  private final Set<String> asked = ConcurrentHashMap.newKeySet(); // filters acknowledged
  private final CompletableFuture<Integer> connected = new CompletableFuture<>();
  private final AwaitedAnswers awaited = new AwaitedAnswers(); // its identifiers guarded by lock
  private final CountDownLatch settled = new CountDownLatch(1);
  private final CountDownLatch ended = new CountDownLatch(1); // counted down by the reader
  private final Object lock = new Object(); // guards the output
  private SocketChannel socket; // set once, by open
  private BrokerChannel channel; // likewise
  private Selector selector; // likewise
  private SelectionKey key; // likewise
  private MqttOutbox outbox; // likewise; guarded by lock
  private int waiting; // unsent messages of QoS 0; guarded by lock
  private volatile long sentMicros;
  private volatile boolean over;
  private volatile boolean closing;
  private volatile boolean cut;

  /**
   * @param address {@code tcp://HOST:PORT}, or {@code ssl://HOST:PORT} if encrypted
   */
  DirectSession(String address, String clientId, long answerWithinMs, Owner owner, Clock clock) {
    this.address = address;
    this.clientId = clientId;
    this.answerWithinMs = answerWithinMs;
    this.owner = owner;
    this.clock = clock;
  }

  @Override
  public void open(MqttConnectOptions options) throws MqttException {
    String hostAndPort = address.substring(address.indexOf("://") + 3);
    int colon = hostAndPort.lastIndexOf(':');
    String host = hostAndPort.substring(0, colon);
    int port = Integer.parseInt(hostAndPort.substring(colon + 1));
    try {
      int withinMs = (int) TimeUnit.SECONDS.toMillis(options.getConnectionTimeout());
      socket = SocketChannel.open();
      socket.setOption(StandardSocketOptions.TCP_NODELAY, true);
      socket.socket().connect(new InetSocketAddress(host, port), withinMs);
      socket.configureBlocking(false);
      selector = Selector.open();
      key = socket.register(selector, SelectionKey.OP_READ);
      channel = channel(options, host, port, withinMs);
    } catch (IOException | IllegalArgumentException e) {
      throw new MqttException(MqttException.REASON_CODE_SERVER_CONNECT_ERROR, e);
    }
    outbox = new MqttOutbox(channel);
    long keepAliveMicros = TimeUnit.SECONDS.toMicros(options.getKeepAliveInterval());
    Thread reader = new Thread(() -> read(keepAliveMicros), "u2sa-mqtt " + clientId);
    reader.setDaemon(true);
    synchronized (lock) {
      put(MqttPackets.connect(clientId, options));
    }
    reader.start(); // sends it, reports a wrong answer, and closes the channel
    int code = await(connected);
    if (code != 0) {
      throw new MqttException(code);
    }
  }

  private BrokerChannel channel(MqttConnectOptions options, String host, int port, int withinMs)
      throws IOException {
    if (options.getSocketFactory() instanceof PromptTlsSockets encryption) {
      TlsChannel tls = new TlsChannel(socket, encryption.engine(host, port));
      tls.shakeHands(selector, clock, withinMs);
      return tls;
    }
    return new BrokerChannel.Plain(socket);
  }

  private <T> T await(CompletableFuture<T> answer) throws MqttException {
    try {
      return answer.get(answerWithinMs, TimeUnit.MILLISECONDS);
    } catch (ExecutionException e) {
      throw new MqttException(MqttException.REASON_CODE_CONNECTION_LOST, e.getCause());
    } catch (TimeoutException e) {
      throw new MqttException(MqttException.REASON_CODE_CLIENT_TIMEOUT);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new MqttException(e);
    }
  }

  @Override
  public boolean publish(
      String topic, byte[] payload, boolean eachMatters, boolean retained, Runnable confirmed)
      throws MqttException {
    byte[] name = topicBytes(topic);
    synchronized (lock) {
      if (over || eachMatters && awaited.isFull()) {
        return false;
      }
      ByteBuffer room = outbox.room(MqttPackets.publishBytes(name, payload));
      if (room == null) {
        return false;
      }
      int packet = eachMatters ? awaited.publishing(confirmed) : 0;
      waiting += eachMatters ? 0 : 1;
      MqttPackets.putPublish(room, name, payload, packet, retained);
      boolean sent = false;
      try {
        sendOutbox();
        sent = true;
      } finally {
        if (!sent) { // reported by the exception
          awaited.forget(packet);
          waiting -= eachMatters ? 0 : 1;
        }
      }
    }
    return true;
  }

  private static byte[] topicBytes(String topic) {
    try {
      return MqttPackets.text(topic);
    } catch (IllegalArgumentException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private void send(ByteBuffer packet) throws MqttException {
    synchronized (lock) {
      put(packet);
      sendOutbox();
    }
  }

  /** Called with the lock. */
  private void put(ByteBuffer packet) throws MqttException {
    ByteBuffer room = outbox.room(packet.remaining());
    if (room == null) {
      throw new MqttException(MqttException.REASON_CODE_MAX_INFLIGHT);
    }
    room.put(packet);
  }

  /** Called with the lock. */
  private void sendOutbox() throws MqttException {
    try {
      outbox.send();
    } catch (IOException e) {
      throw new MqttException(MqttException.REASON_CODE_CONNECTION_LOST, e);
    }
    sentMicros = clock.micros();
    if (outbox.isEmpty()) {
      waiting = 0;
    } else {
      selector.wakeup(); // the reader sends the rest
    }
  }

  @Override
  public Set<String> subscribe(boolean eachMatters, String... filters) throws MqttException {
    byte[] granted = ask(packet -> MqttPackets.subscribe(packet, eachMatters ? 1 : 0, filters));
    Set<String> refused = new LinkedHashSet<>();
    for (int i = 0; i < filters.length; i++) {
      if (i >= granted.length || (granted[i] & REFUSED) != 0) {
        refused.add(filters[i]);
      }
    }
    asked.addAll(Arrays.asList(filters));
    return refused;
  }

  @Override
  public void unsubscribe(String... filters) throws MqttException {
    Arrays.asList(filters).forEach(asked::remove);
    ask(packet -> MqttPackets.unsubscribe(packet, filters));
  }

  @FunctionalInterface
  private interface Question {
    ByteBuffer numbered(int packet);
  }

  private byte[] ask(Question question) throws MqttException {
    CompletableFuture<byte[]> answer = new CompletableFuture<>();
    int packet;
    synchronized (lock) {
      packet = awaited.asking(answer);
      if (over) {
        answer.completeExceptionally(new IOException("the session is over"));
      }
    }
    try {
      if (!answer.isDone()) {
        send(question.numbered(packet));
      }
      return await(answer);
    } finally {
      awaited.forget(packet);
    }
  }

  @Override
  public boolean hasAsked(String filter) {
    return asked.contains(filter);
  }

  @Override
  public boolean isOver() {
    return over;
  }

  @Override
  public long close() {
    closing = true;
    settle();
    try {
      settled.await(answerWithinMs, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // makes the close end immediately
    }
    long lost = end();
    cut = true; // the broker closing it now is not a loss
    try {
      send(MqttPackets.empty(DISCONNECT));
      ended.await(FAREWELL_WITHIN_MS, TimeUnit.MILLISECONDS);
    } catch (MqttException e) {
      return lost + abandon(); // the connection broke in the meantime
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return lost + abandon();
  }

  @Override
  public long abandon() {
    cut = true;
    long lost = end();
    try {
      if (socket != null) {
        socket.close();
      }
      if (selector != null) {
        selector.wakeup(); // the reading thread closes it
      }
    } catch (IOException e) {
      return lost; // closed anyway
    }
    return lost;
  }

  @Override
  public long end() {
    synchronized (lock) {
      if (over) {
        return 0;
      }
      over = true;
      return awaited.unconfirmed() + waiting;
    }
  }

  private void settle() {
    synchronized (lock) {
      if (closing && awaited.unconfirmed() == 0 && outbox.isEmpty()) {
        settled.countDown();
      }
    }
  }

  private void read(long keepAliveMicros) {
    MqttPacketReader packets = new MqttPacketReader(new FromBroker());
    String why;
    try (Selector closed = selector;
        SocketChannel closedToo = socket) {
      LinkCheck link = new LinkCheck(clock::micros, keepAliveMicros);
      PromptAcknowledgements acknowledgements = new PromptAcknowledgements(closedToo);
      while (true) {
        synchronized (lock) {
          key.interestOps(
              outbox.isEmpty()
                  ? SelectionKey.OP_READ
                  : SelectionKey.OP_READ | SelectionKey.OP_WRITE);
        }
        if (channel.hasUnread()) {
          closed.selectNow();
        } else {
          closed.select(connected.isDone() ? link.waitMs(sentMicros) : link.waitMs());
        }
        // An unselected key still holds the ready set of the previous selection.
        boolean readable =
            channel.hasUnread() || closed.selectedKeys().contains(key) && key.isReadable();
        closed.selectedKeys().clear();
        if (readable) {
          packets.read(channel); // only once: acknowledgements must go out even in a flood
          acknowledgements.renew();
          link.heard();
        }
        sendRest();
        if (connected.isDone() && link.isToAsk(sentMicros)) {
          send(MqttPackets.empty(PINGREQ));
        }
      }
    } catch (IOException | CancelledKeyException e) {
      why = e.getMessage();
    } catch (MqttException e) {
      why = MqttSession.reason(e);
    } catch (RuntimeException | Error e) { // a new session may recover, from lack of memory too
      why = e.toString();
    }
    broke(why);
  }

  private void sendRest() throws MqttException {
    synchronized (lock) {
      if (!outbox.isEmpty()) {
        sendOutbox();
      }
    }
    if (closing) {
      settle();
    }
  }

  private void broke(String why) {
    IOException broken = new IOException(why);
    connected.completeExceptionally(broken);
    try {
      if (!cut) {
        owner.lost(this, why);
      }
    } finally {
      synchronized (lock) {
        over = true;
        awaited.fail(broken);
      }
      settled.countDown();
      ended.countDown();
    }
  }

  private final class FromBroker implements MqttPacketReader.Handler {
    @Override
    public void connected(int code) {
      connected.complete(code);
    }

    @Override
    public void message(String topic, byte[] payload, int packetId, boolean retained) {
      if (!cut) {
        owner.arrived(topic, payload, retained);
      }
      acknowledge(packetId);
    }

    @Override
    public void skipped(String topic, int bytes, int packetId) {
      if (!cut) {
        owner.skipped(topic, bytes);
      }
      acknowledge(packetId);
    }

    private void acknowledge(int packetId) {
      if (packetId != 0) {
        synchronized (lock) {
          ByteBuffer room = outbox.room(MqttPackets.PUBACK_BYTES);
          if (room != null) { // if full, the broker receives nothing anyway and closes it
            MqttPackets.putPubAck(room, packetId);
          }
        }
      }
    }

    @Override
    public void answered(int packetId, byte[] codes) {
      awaited.answered(packetId, codes);
    }
  }
}
