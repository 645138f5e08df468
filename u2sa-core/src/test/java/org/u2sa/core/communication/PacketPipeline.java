package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ChannelOption;
import io.netty.channel.ChannelOutboundHandlerAdapter;
import io.netty.channel.ChannelPromise;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.mqtt.MqttDecoder;
import io.netty.handler.codec.mqtt.MqttEncoder;
import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.util.ReferenceCountUtil;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/**
 * The handlers of one client's connection without a network, a thread or Moquette: what Moquette
 * would get is read by the test. Counts what the decoder is given.
 */
final class PacketPipeline implements AutoCloseable {
  static final String TOPIC = "u2sa/cessna/state/StateInformation";

  private static final int CONNACK = 0x20;
  private static final int PUBLISH = 3;

  List<String> log = new CopyOnWriteArrayList<>();
  final ConnectionFilter filter;
  final BrokerState broker;
  final ClientSession session;
  final EmbeddedChannel channel = new Addressed();
  final List<Integer> decoded = new ArrayList<>(); // bytes of each buffer that the decoder got
  Inflow inflow;
  private final Deque<Runnable> unread = new ArrayDeque<>(); // what the client has not taken
  private boolean isDeaf;
  private boolean isBlocked;
  private long nowMicros;

  PacketPipeline() {
    this(Map.of());
  }

  PacketPipeline(Map<String, Object> variables) {
    this(variables, null);
  }

  /** The first client of a broker with users, who have no need of a network to log in. */
  PacketPipeline(Map<String, Object> variables, Users users) {
    filter =
        new ConnectionFilter(
            XmlConfiguration.inMemory("test", variables).settings(BrokerLimits.class).get(),
            new MessageCodec(StandardTypes.registry()),
            new TestClock(),
            users,
            null,
            log::add);
    broker = filter.broker;
    session = build();
  }

  /** Another client of the same broker. */
  PacketPipeline(PacketPipeline first) {
    filter = first.filter;
    broker = filter.broker;
    log = first.log;
    session = build();
  }

  private ClientSession build() {
    Outflow outflow = new Outflow(broker);
    ClientSession built = new ClientSession(broker, outflow);
    inflow = new Inflow(broker, built);
    built.inflow(inflow);
    broker.router.runOn(channel.eventLoop());
    channel.freezeTime();
    channel
        .config()
        .setOption(
            ChannelOption.WRITE_BUFFER_WATER_MARK,
            new WriteBufferWaterMark(32 << 20, 64 << 20)); // as the Acceptor does
    channel
        .pipeline()
        .addLast(
            new Network(),
            new ReceivedBytes(built, inflow),
            new PacketFramer(built, inflow, broker.unfinished),
            new Counter(),
            new MqttDecoder(BrokerLimits.LONGEST_PACKET),
            MqttEncoder.INSTANCE,
            inflow,
            built,
            outflow);
    return built;
  }

  /** A channel with an address of the Internet. */
  private static final class Addressed extends EmbeddedChannel {
    @Override
    protected SocketAddress remoteAddress0() {
      return new InetSocketAddress("127.0.0.1", 1);
    }
  }

  private final class TestClock implements Clock {
    @Override
    public long micros() {
      return nowMicros;
    }

    @Override
    public Waiter newWaiter(String name) {
      return new SystemClock().newWaiter(name); // of the thread that checks passwords
    }
  }

  private final class Counter extends ChannelInboundHandlerAdapter {
    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      decoded.add(((ByteBuf) message).readableBytes());
      ctx.fireChannelRead(message);
    }
  }

  /** Keeps what is sent to a client that reads nothing. */
  private final class Network extends ChannelOutboundHandlerAdapter {
    @Override
    public void write(ChannelHandlerContext ctx, Object message, ChannelPromise promise) {
      if (isDeaf) {
        unread.add(() -> ctx.writeAndFlush(message, promise));
      } else {
        ctx.write(message, promise);
      }
    }

    @Override
    public void flush(ChannelHandlerContext ctx) {
      if (!isBlocked) {
        ctx.flush();
      }
    }
  }

  /** From now on the client's socket takes nothing: what is sent counts as unread. */
  void block() {
    isBlocked = true;
  }

  /** The client's socket takes what was sent, and what will be. */
  void unblock() {
    isBlocked = false;
    channel.flush();
    channel.runPendingTasks();
  }

  /** Number of packets the client's socket has taken since the last call. */
  int sentPackets() {
    int packets = 0;
    for (ByteBuf packet = channel.readOutbound(); packet != null; packet = channel.readOutbound()) {
      packet.release();
      packets++;
    }
    return packets;
  }

  /** Lets seconds pass, with the broker's look at the client in each. */
  void passSeconds(int seconds) {
    for (int i = 0; i < seconds; i++) {
      pass(1_000);
    }
  }

  /** From now on the client reads nothing. */
  void readNothing() {
    isDeaf = true;
  }

  /** The client reads what was sent, and what will be. Returns how many packets waited. */
  int read() {
    isDeaf = false;
    int packets = unread.size();
    unread.forEach(Runnable::run);
    unread.clear();
    return packets;
  }

  /** Connects as Moquette would confirm it. What the decoder got for that does not count. */
  PacketPipeline introduced() {
    return introduced("client");
  }

  /** The same under another client ID: a client with the same one would be replaced. */
  PacketPipeline introduced(String clientId) {
    send(MqttPacketBytes.connect(clientId, 0));
    broker.clients.connected(session.connection());
    pass(2);
    taken();
    decoded.clear();
    return this;
  }

  /** Receives bytes in one piece. */
  void send(byte[] bytes) {
    channel.writeInbound(Unpooled.wrappedBuffer(bytes));
    channel.runPendingTasks();
  }

  /** Receives bytes one by one, until the connection ends. Returns how many were received. */
  int drip(byte[] bytes) {
    int sent = 0;
    while (sent < bytes.length && channel.isOpen()) {
      send(new byte[] {bytes[sent]});
      sent++;
    }
    return sent;
  }

  void pass(int milliseconds) {
    nowMicros += 1_000L * milliseconds;
    channel.advanceTimeBy(milliseconds, TimeUnit.MILLISECONDS);
    channel.runScheduledPendingTasks();
    channel.runPendingTasks();
  }

  /** Types of the packets that Moquette would have got since the last call. */
  List<String> taken() {
    List<String> types = new ArrayList<>();
    for (MqttMessage message = channel.readInbound();
        message != null;
        message = channel.readInbound()) {
      types.add(message.fixedHeader().messageType().toString());
      ReferenceCountUtil.release(message);
    }
    return types;
  }

  /**
   * What the client was sent since the last call: the first byte of each packet as two hexadecimal
   * digits, of messages also the payload, a letter for each byte, and of CONNACK the code.
   */
  List<String> sent() {
    ByteBuf all = Unpooled.buffer();
    for (ByteBuf part = channel.readOutbound(); part != null; part = channel.readOutbound()) {
      all.writeBytes(part);
      part.release();
    }
    List<String> packets = new ArrayList<>();
    while (all.isReadable()) {
      int first = all.readUnsignedByte();
      ByteBuf content = all.readSlice(all.readByte()); // short ones
      String payload = "";
      if (first == CONNACK) {
        payload = " " + content.getByte(1);
      } else if (first >> 4 == PUBLISH) {
        content.skipBytes(content.readUnsignedShort() + ((first & 0x06) == 0 ? 0 : Short.BYTES));
        payload = " " + content.toString(StandardCharsets.ISO_8859_1);
      }
      packets.add(Integer.toHexString(first) + payload);
    }
    all.release();
    return packets;
  }

  /** Identifiers of the messages of QoS 1 that the client was sent since the last call. */
  List<Integer> sentIdentifiers() {
    List<Integer> identifiers = new ArrayList<>();
    for (ByteBuf packet = channel.readOutbound(); packet != null; packet = channel.readOutbound()) {
      if (packet.readByte() == 0x32) {
        packet.skipBytes(1);
        packet.skipBytes(packet.readUnsignedShort());
        identifiers.add(packet.readUnsignedShort());
      }
      packet.release();
    }
    return identifiers;
  }

  @Override
  public void close() {
    channel.finishAndReleaseAll();
  }
}
