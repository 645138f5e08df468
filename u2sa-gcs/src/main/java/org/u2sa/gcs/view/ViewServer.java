package org.u2sa.gcs.view;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.ChannelOutboundHandlerAdapter;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.nio.NioEventLoopGroup;
import io.netty.channel.socket.SocketChannel;
import io.netty.channel.socket.nio.NioServerSocketChannel;
import io.netty.handler.codec.http.HttpObjectAggregator;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolConfig;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.message.JsonReader;

/**
 * Serves channels to viewers by the Foxglove WebSocket protocol, version 1: server info,
 * advertisements, status, messages. Reads subscriptions, and answers everything else with an error.
 */
public final class ViewServer implements AutoCloseable {
  private static final String SUBPROTOCOLS = "foxglove.sdk.v1,foxglove.websocket.v1";
  private static final int LONGEST_REQUEST = 1 << 16;
  private static final int LONGEST_FRAME = 1 << 20;
  private static final WriteBufferWaterMark BUFFER = new WriteBufferWaterMark(1 << 20, 4 << 20);
  private static final int MAX_VIEWERS = 32;
  private static final int MAX_CHANNELS = 2048; // of a running system
  private static final int MAX_SOCKETS = 2 * MAX_VIEWERS; // before and after the handshake
  private static final int HANDSHAKE_WITHIN_S = 10;
  private static final int END_MS = 500;

  private final String name;
  private final boolean tellsTime;
  private final Set<String> origins;
  private final String sessionId;
  private final Consumer<String> remarks;
  private final ViewChannels channels = new ViewChannels();
  private final Set<ViewerSession> viewers = ConcurrentHashMap.newKeySet();
  private final NioEventLoopGroup threads = new NioEventLoopGroup(1);
  private final AtomicInteger sockets = new AtomicInteger();
  private volatile boolean saidFull;
  private final Channel listening;

  /**
   * Starts listening.
   *
   * @param name name of the source
   * @param sessionId a new ID makes viewers discard their data
   * @param tellsTime whether viewers use {@link #time} as their clock, as for a recording
   * @param origins additional web pages that may connect, see {@link OriginCheck}
   * @param remarks receives connects and disconnects
   * @throws RunFailedException if the port is taken
   */
  public ViewServer(
      InetSocketAddress address,
      String name,
      String sessionId,
      boolean tellsTime,
      Set<String> origins,
      Consumer<String> remarks) {
    this.name = name;
    this.origins = Set.copyOf(origins);
    this.sessionId = sessionId;
    this.tellsTime = tellsTime;
    this.remarks = remarks;
    try {
      listening =
          new ServerBootstrap()
              .group(threads)
              .channel(NioServerSocketChannel.class)
              .childOption(ChannelOption.WRITE_BUFFER_WATER_MARK, BUFFER)
              .childOption(ChannelOption.TCP_NODELAY, true)
              .childHandler(new Initializer())
              .bind(address)
              .syncUninterruptibly()
              .channel();
    } catch (RuntimeException | Error e) {
      threads.shutdownGracefully(0, END_MS, TimeUnit.MILLISECONDS);
      throw e;
    } catch (Exception e) { // Netty throws checked exceptions without declaring them
      threads.shutdownGracefully(0, END_MS, TimeUnit.MILLISECONDS);
      throw new RunFailedException("cannot listen on " + address + ": " + e.getMessage(), e);
    }
  }

  /** Address on which it listens. */
  public InetSocketAddress address() {
    return (InetSocketAddress) listening.localAddress();
  }

  int viewers() {
    return viewers.size();
  }

  boolean isWatched() {
    return viewers.stream().anyMatch(ViewerSession::hearsAnything);
  }

  /**
   * Whether the topic has a channel or may get one. Limited, because a running system may produce
   * endless source names.
   */
  boolean hasRoomFor(String topic) {
    if (channels.of(topic).isPresent() || channels.size() < MAX_CHANNELS) {
      return true;
    }
    if (!saidFull) {
      saidFull = true;
      remarks.accept("more than " + MAX_CHANNELS + " topics: further ones are not shown");
    }
    return false;
  }

  /** The channel of a topic; created and announced to all if new. */
  ViewChannel channel(
      String topic, String encoding, String schemaName, Supplier<byte[]> schema, boolean latched) {
    return channels
        .of(topic)
        .orElseGet(
            () -> {
              ViewChannel added = channels.add(topic, encoding, schemaName, schema.get(), latched);
              viewers.forEach(viewer -> viewer.send(advertise(List.of(added))));
              return added;
            });
  }

  /**
   * Sends a message to the subscribers of its channel. Does not block.
   *
   * @param nanos time of receipt [ns]
   * @param data evaluated only if a viewer gets it, now or later
   */
  void publish(ViewChannel channel, long nanos, Supplier<byte[]> data) {
    byte[] bytes = null;
    if (channel.latched()) {
      bytes = data.get();
      channels.keep(channel, nanos, bytes);
    }
    for (ViewerSession viewer : viewers) {
      if (viewer.hears(channel.id())) {
        bytes = bytes == null ? data.get() : bytes;
        viewer.message(channel.id(), nanos, bytes);
      }
    }
  }

  /** Sends the current time to all viewers [ns]. */
  void time(long nanos) {
    viewers.forEach(viewer -> viewer.time(nanos));
  }

  @Override
  public void close() {
    listening.close().syncUninterruptibly();
    threads.shutdownGracefully(0, END_MS, TimeUnit.MILLISECONDS).syncUninterruptibly();
  }

  private static JsonText advertise(List<ViewChannel> channels) {
    List<JsonText> all = new ArrayList<>();
    channels.forEach(channel -> all.add(channel.advertisement()));
    return new JsonText().put("op", "advertise").put("channels", all);
  }

  private JsonText serverInfo() {
    return new JsonText()
        .put("op", "serverInfo")
        .put("name", name)
        .put("capabilities", tellsTime ? List.of("time") : List.of())
        .put("supportedEncodings", List.of())
        .put("metadata", new JsonText())
        .put("sessionId", sessionId);
  }

  private final class Initializer extends ChannelInitializer<SocketChannel> {
    @Override
    protected void initChannel(SocketChannel socket) {
      if (sockets.incrementAndGet() > MAX_SOCKETS) {
        sockets.decrementAndGet();
        socket.close();
        return;
      }
      socket.closeFuture().addListener(closed -> sockets.decrementAndGet());
      socket
          .pipeline()
          .addLast(new ReadsWhileWritable())
          .addLast(new HttpServerCodec())
          .addLast(new HttpObjectAggregator(LONGEST_REQUEST))
          .addLast(new OriginCheck(origins))
          .addLast(
              new WebSocketServerProtocolHandler(
                  WebSocketServerProtocolConfig.newBuilder()
                      .websocketPath("/")
                      .checkStartsWith(true)
                      .subprotocols(SUBPROTOCOLS)
                      .maxFramePayloadLength(LONGEST_FRAME)
                      .build()))
          .addLast(new Conversation());
    }
  }

  /**
   * Netty's own handler keeps reading after each ping and pong, regardless of the channel's
   * auto-read.
   */
  private static final class ReadsWhileWritable extends ChannelOutboundHandlerAdapter {
    @Override
    public void read(ChannelHandlerContext context) {
      if (context.channel().isWritable()) {
        context.read();
      }
    }
  }

  private final class Conversation extends SimpleChannelInboundHandler<WebSocketFrame> {
    private ViewerSession viewer; // null until the handshake is complete

    @Override
    public void userEventTriggered(ChannelHandlerContext context, Object event) throws Exception {
      if (event instanceof WebSocketServerProtocolHandler.HandshakeComplete complete) {
        begin(context, complete.selectedSubprotocol());
      }
      super.userEventTriggered(context, event);
    }

    private void begin(ChannelHandlerContext context, String subprotocol) {
      if (subprotocol == null) {
        close(context, "expected one of the subprotocols " + SUBPROTOCOLS);
        return;
      }
      if (viewers.size() >= MAX_VIEWERS) {
        close(context, "there are " + MAX_VIEWERS + " viewers already");
        return;
      }
      viewer = new ViewerSession(context.channel());
      viewer.send(serverInfo());
      viewers.add(viewer); // before reading the channels, lest one be missed
      List<ViewChannel> known = channels.all();
      if (!known.isEmpty()) {
        viewer.send(advertise(known));
      }
      remarks.accept("viewer " + viewer.address() + " came (" + subprotocol + ")");
    }

    private void close(ChannelHandlerContext context, String why) {
      context.writeAndFlush(new CloseWebSocketFrame(WebSocketCloseStatus.PROTOCOL_ERROR, why));
      context.close();
    }

    @Override
    public void handlerAdded(ChannelHandlerContext context) {
      context
          .executor()
          .schedule(() -> requireViewer(context), HANDSHAKE_WITHIN_S, TimeUnit.SECONDS);
    }

    private void requireViewer(ChannelHandlerContext context) {
      if (viewer == null) {
        context.close();
      }
    }

    /** Stops reading requests and pings from a viewer that does not read its answers. */
    @Override
    public void channelWritabilityChanged(ChannelHandlerContext context) throws Exception {
      context.channel().config().setAutoRead(context.channel().isWritable());
      super.channelWritabilityChanged(context);
    }

    @Override
    public void channelInactive(ChannelHandlerContext context) throws Exception {
      if (viewer != null && viewers.remove(viewer)) {
        remarks.accept(
            "viewer "
                + viewer.address()
                + " left; "
                + viewer.sent()
                + " messages sent, "
                + viewer.dropped()
                + " dropped because it read too slowly");
      }
      super.channelInactive(context);
    }

    @Override
    public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
      remarks.accept("viewer " + context.channel().remoteAddress() + ": " + cause.getMessage());
      context.close();
    }

    @Override
    protected void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
      if (viewer == null) {
        return; // rejected and about to be closed
      }
      if (!(frame instanceof TextWebSocketFrame text)) {
        viewer.status(ViewerSession.Level.ERROR, "read-only: messages of viewers are not taken");
        return;
      }
      try {
        take(JsonReader.object("request", text.text()));
      } catch (BadInputException e) {
        viewer.status(ViewerSession.Level.ERROR, e.getMessage());
      }
    }

    private void take(Map<String, Object> request) {
      Object operation = request.get("op");
      if ("subscribe".equals(operation)) {
        list(request, "subscriptions").forEach(this::subscribe);
      } else if ("unsubscribe".equals(operation)) {
        list(request, "subscriptionIds").forEach(this::unsubscribe);
      } else {
        viewer.status(
            ViewerSession.Level.ERROR,
            "read-only: \"" + operation + "\" is not served; expected subscribe or unsubscribe");
      }
    }

    private void subscribe(Object element) {
      if (!(element instanceof Map<?, ?> each)
          || !(each.get("id") instanceof Long id)
          || !(each.get("channelId") instanceof Long channelId)) {
        viewer.status(
            ViewerSession.Level.ERROR, "subscription " + element + ": expected id and channelId");
        return;
      }
      if (!channels.has(channelId)) {
        viewer.status(ViewerSession.Level.WARNING, "no channel " + channelId);
        return;
      }
      String refused = viewer.subscribe(id, channelId.intValue());
      if (refused != null) {
        viewer.status(ViewerSession.Level.WARNING, refused);
        return;
      }
      channels
          .last(channelId.intValue())
          .ifPresent(last -> viewer.message(id, last.nanos(), last.data()));
    }

    private void unsubscribe(Object id) {
      if (!(id instanceof Long known) || !viewer.unsubscribe(known)) {
        viewer.status(ViewerSession.Level.WARNING, "no subscription " + id);
      }
    }

    private List<?> list(Map<String, Object> request, String key) {
      if (request.get(key) instanceof List<?> list) {
        return list;
      }
      throw new BadInputException("request " + request.get("op") + ": expected a list " + key);
    }
  }
}
