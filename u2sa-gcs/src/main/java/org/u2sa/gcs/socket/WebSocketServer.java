package org.u2sa.gcs.socket;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.buffer.ByteBufAllocator;
import io.netty.buffer.PooledByteBufAllocator;
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
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrameAggregator;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolConfig;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import io.netty.handler.ssl.SslContext;
import io.netty.handler.ssl.SslContextBuilder;
import io.netty.handler.ssl.SslProvider;
import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.net.ssl.SSLException;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;

/**
 * Accepts WebSocket clients on a TCP port, with limits on everything they may send or keep open.
 */
public final class WebSocketServer implements AutoCloseable {
  private static final int LONGEST_REQUEST = 1 << 16;
  private static final int LONGEST_MESSAGE = 1 << 17; // orders have at most 64 KiB
  private static final long LARGEST_BUFFER = 4 << 20; // unread bytes of a client
  private static final long HEAP_PART = 8; // of all clients' unread bytes together
  private static final int RESUME_PART = 4; // level of a full buffer at which it accepts more
  private static final int END_MS = 500;

  /**
   * Incomplete messages are kept on the heap in chunks of 256 KiB instead of 4 MiB: a small heap
   * comes with equally little buffer memory, and when that is used up the broker's network thread
   * waits for the garbage collector.
   */
  private static final ByteBufAllocator MEMORY =
      new PooledByteBufAllocator(false, 1, 1, 8_192, 5, 0, 0, false);

  /**
   * Settings of a server.
   *
   * @param address address on which it listens
   * @param subprotocols names, separated by commas; empty: none is agreed
   * @param origins web pages that may connect besides those of {@link OriginCheck}
   * @param maxClients clients at a time; as many more connections may be in their handshake; a
   *     newer one displaces the oldest
   * @param security certificate and key; empty: no encryption
   */
  public record Offer(
      InetSocketAddress address,
      String subprotocols,
      Set<String> origins,
      int maxClients,
      Optional<SecurityDirectory> security) {}

  /** Receives a client's messages and its disconnection, on the server's thread. */
  public interface Conversation {
    void text(String text);

    /** Handles a binary message, whose content is dropped. */
    void binary();

    void ended();

    /** Whether this client gives way to one that names a user if there are too many. */
    boolean givesWay();
  }

  private final Offer offer;
  private final Function<ClientSocket, Conversation> welcome;
  private final Consumer<String> remarks;
  private final Optional<SslContext> tls;
  private final NioEventLoopGroup threads = new NioEventLoopGroup(1);
  private final ClientPlaces places; // this and the next: the server's thread only
  private long faults;
  private final Channel listening;

  /**
   * Starts listening.
   *
   * @param welcome starts the session with a newly connected client
   * @param remarks receives connection failures
   * @throws RunFailedException if the port is taken
   */
  public WebSocketServer(
      Offer offer, Function<ClientSocket, Conversation> welcome, Consumer<String> remarks) {
    this.offer = offer;
    this.welcome = welcome;
    this.remarks = remarks;
    places = new ClientPlaces(offer.maxClients());
    tls = offer.security().map(WebSocketServer::encryption);
    try {
      listening =
          new ServerBootstrap()
              .group(threads)
              .channel(NioServerSocketChannel.class)
              .childOption(ChannelOption.WRITE_BUFFER_WATER_MARK, buffer(offer.maxClients()))
              .childOption(ChannelOption.TCP_NODELAY, true)
              .childOption(ChannelOption.ALLOCATOR, MEMORY)
              .childHandler(new Initializer())
              .bind(offer.address())
              .syncUninterruptibly()
              .channel();
    } catch (RuntimeException | Error e) {
      threads.shutdownGracefully(0, END_MS, TimeUnit.MILLISECONDS);
      throw e;
    } catch (Exception e) { // Netty throws checked exceptions without declaring them
      threads.shutdownGracefully(0, END_MS, TimeUnit.MILLISECONDS);
      throw new RunFailedException(
          "cannot listen on " + offer.address() + ": " + e.getMessage(), e);
    }
  }

  /** Limits the memory of all clients that do not read, so that the vehicle keeps its heap. */
  static WriteBufferWaterMark buffer(int clients) {
    long share = Runtime.getRuntime().maxMemory() / HEAP_PART / clients;
    int high = (int) Math.min(LARGEST_BUFFER, share);
    return new WriteBufferWaterMark(high / RESUME_PART, high);
  }

  private static SslContext encryption(SecurityDirectory directory) {
    try {
      return SslContextBuilder.forServer(directory.certificate().toFile(), directory.key().toFile())
          .sslProvider(SslProvider.JDK)
          .protocols("TLSv1.3", "TLSv1.2")
          .build();
    } catch (SSLException | IllegalArgumentException e) {
      throw new BadInputException(
          directory.path() + ": server.pem and server-key.pem cannot be used: " + e.getMessage(),
          e);
    }
  }

  /** Address on which it listens. */
  public InetSocketAddress address() {
    return (InetSocketAddress) listening.localAddress();
  }

  /** Runs a task on the server's thread after a delay [ms]. */
  public Future<?> schedule(Runnable task, long delayMs) {
    return threads.schedule(task, delayMs, TimeUnit.MILLISECONDS);
  }

  @Override
  public void close() {
    listening.close().syncUninterruptibly();
    threads.shutdownGracefully(0, END_MS, TimeUnit.MILLISECONDS).syncUninterruptibly();
  }

  private final class Initializer extends ChannelInitializer<SocketChannel> {
    @Override
    protected void initChannel(SocketChannel socket) {
      places.connected(socket);
      tls.ifPresent(context -> socket.pipeline().addLast(context.newHandler(socket.alloc())));
      WebSocketServerProtocolConfig.Builder protocol =
          WebSocketServerProtocolConfig.newBuilder()
              .websocketPath("/")
              .checkStartsWith(true)
              .maxFramePayloadLength(LONGEST_MESSAGE);
      if (!offer.subprotocols().isEmpty()) {
        protocol.subprotocols(offer.subprotocols());
      }
      socket
          .pipeline()
          .addLast(new ReadsWhileWritable())
          .addLast(new HttpServerCodec())
          .addLast(new HttpObjectAggregator(LONGEST_REQUEST))
          .addLast(new OriginCheck(offer.origins()))
          .addLast(new WebSocketServerProtocolHandler(protocol.build()))
          .addLast(new WebSocketFrameAggregator(LONGEST_MESSAGE))
          .addLast(new Connection());
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

  private final class Connection extends SimpleChannelInboundHandler<WebSocketFrame> {
    private Conversation conversation; // null until the handshake is complete
    private ClientSocket socket;

    @Override
    public void userEventTriggered(ChannelHandlerContext context, Object event) throws Exception {
      if (event instanceof WebSocketServerProtocolHandler.HandshakeComplete complete) {
        begin(
            new ClientSocket(
                context.channel(), complete.requestHeaders(), complete.selectedSubprotocol()),
            context.channel());
      }
      super.userEventTriggered(context, event);
    }

    private void begin(ClientSocket client, Channel channel) {
      if (!offer.subprotocols().isEmpty() && client.subprotocol().isEmpty()) {
        client.close("expected one of the subprotocols " + offer.subprotocols());
      } else if (!places.areOpenTo(client)) {
        client.close("there are " + offer.maxClients() + " clients already");
      } else {
        socket = client;
        conversation = welcome.apply(client);
        places.enter(channel, client, conversation);
      }
    }

    /** Stops reading messages and pings from a client that does not read its answers. */
    @Override
    public void channelWritabilityChanged(ChannelHandlerContext context) throws Exception {
      context.channel().config().setAutoRead(context.channel().isWritable());
      super.channelWritabilityChanged(context);
    }

    @Override
    public void channelInactive(ChannelHandlerContext context) throws Exception {
      if (conversation != null) {
        places.leave(socket);
        conversation.ended();
      }
      super.channelInactive(context);
    }

    @Override
    public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
      if (Long.bitCount(++faults) == 1) { // 1, 2, 4, 8…: clients determine how many there are
        remarks.accept(
            String.format(
                "%s: %s (%d so far)",
                context.channel().remoteAddress(), cause.getMessage(), faults));
      }
      context.close();
    }

    @Override
    protected void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
      if (conversation == null) {
        return; // rejected and about to be closed
      }
      if (frame instanceof TextWebSocketFrame text) {
        conversation.text(text.text());
      } else {
        conversation.binary();
      }
    }
  }
}
