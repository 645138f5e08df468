package org.u2sa.core.communication;

import io.netty.channel.AdaptiveRecvByteBufAllocator;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ChannelOption;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.util.AttributeKey;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.communication.limit.AcceptRate;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.web.WebConnection;
import org.u2sa.core.communication.web.WebInput;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;

/**
 * Filter between the network and Moquette: rate-limits, authenticates and monitors every
 * connection. Moquette accepts only connections admitted here.
 */
final class ConnectionFilter implements AutoCloseable {
  /**
   * Beyond this limit Moquette would drop silently; the connection filter drops earlier and counts.
   */
  private static final int NEVER_UNWRITABLE = 64 << 20;

  /** Set for connections that pass this filter; earlier connections are unlimited. */
  static final AttributeKey<Boolean> FILTERED = AttributeKey.valueOf("u2sa-filtered");

  /** Moquette's handler of a WebSocket's frames, only in the pipelines of the web port. */
  private static final String WEB_SOCKET = "webSocketHandler";

  private static final long ACCEPT_AGAIN_AFTER_MS = 200;

  /** Connections accepted per second from unknown networks, see {@link AcceptRate}. */
  static final double ACCEPTED_PER_S = 2_000.0;

  static final double ENCRYPTED_PER_S = 200.0; // each handshake costs milliseconds

  /** The web port's, which needs few: a browser opens six. */
  static final double WEB_ACCEPTED_PER_S = 400.0;

  /** Further connections refused per second; the rest wait in the listen backlog. */
  private static final double REFUSED_PER_S = 20_000.0;

  private static final double REFUSED_AT_ONCE = 200.0;

  private static final long REFUSE_AGAIN_AFTER_MS = 10;

  private static final int MIN_READ = 512;

  /** Moquette handlers that log and count each packet, unused here. */
  private static final List<String> MOQUETTES_OBSERVERS = List.of("messageLogger", "metrics");

  final BrokerState broker; // state shared by the sessions
  private final Clock clock;
  private final Encryption encryption; // null: plain text
  private final AtomicInteger open = new AtomicInteger();
  private WebPort web; // null: none

  /**
   * @param users the known users; null lets anyone connect without a password
   * @param encryption closed with this; null for plain text
   */
  ConnectionFilter(
      BrokerLimits limits,
      MessageCodec codec,
      Clock clock,
      Users users,
      Encryption encryption,
      Consumer<String> log) {
    this.clock = clock;
    this.encryption = encryption;
    broker = new BrokerState(limits, codec, clock, users, log);
  }

  /** Serves the operator's page on the web port; call before the filter is installed. */
  void serve(WebPort port) {
    web = port;
  }

  /** First handler of a listening socket's pipeline. */
  Acceptor acceptor(SocketAddress listening) {
    return new Acceptor(
        web != null
            && listening instanceof InetSocketAddress address
            && address.getPort() == web.address().getPort());
  }

  /**
   * Called by Moquette: returns whether this filter admitted the connection.
   *
   * @throws StartingException if not, because the filter was not installed yet: the connection
   *     closes without an answer and the client retries, whereas "wrong password" would be final
   */
  boolean letIn(byte[] password) {
    if (!broker.isPass(password)) {
      throw new StartingException();
    }
    return true;
  }

  /** Has no stack trace, because Moquette would log it although there is no error. */
  static final class StartingException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StartingException() {
      super("the broker is still starting; the client will retry", null, false, false);
    }
  }

  /** First handler of the listening socket's pipeline; receives each new connection. */
  final class Acceptor extends ChannelInboundHandlerAdapter {
    private final AcceptRate rate;
    private final int most; // connections of all ports
    private final Allowance refused =
        new Allowance(REFUSED_PER_S, REFUSED_AT_ONCE, broker.nowMicros());

    private Acceptor(boolean isWeb) {
      double perS = isWeb ? WEB_ACCEPTED_PER_S : ACCEPTED_PER_S;
      rate =
          new AcceptRate(
              encryption == null ? perS : Math.min(perS, ENCRYPTED_PER_S), broker.nowMicros());
      // Those of the web port leave room for as many of the MQTT port.
      most = broker.limits.maxClients() + (isWeb ? 1 : 2) * BrokerLimits.PENDING;
    }

    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      Channel child = (Channel) message;
      if (isTooMuch(child.remoteAddress())) { // before any handler is created for it
        broker.refusals.add(
            "connection refused, too many per second", String.valueOf(child.remoteAddress()));
        child.unsafe().closeForcibly();
        refused.take(1.0, broker.nowMicros());
        if (!refused.isOpen(broker.nowMicros())) {
          pause(ctx, REFUSE_AGAIN_AFTER_MS);
        }
        return;
      }
      // Pending and admitted connections are counted apart; this bounds both together.
      if (open.incrementAndGet() > most || broker.isEnding()) {
        open.decrementAndGet();
        broker.refusals.add(
            "connection refused, " + (broker.isEnding() ? "the broker ends" : "too many"),
            String.valueOf(child.remoteAddress()));
        child.unsafe().closeForcibly();
        return;
      }
      child.closeFuture().addListener(closed -> open.decrementAndGet());
      child
          .config()
          .setOption(
              ChannelOption.WRITE_BUFFER_WATER_MARK,
              new WriteBufferWaterMark(NEVER_UNWRITABLE / 2, NEVER_UNWRITABLE));
      // One thread reads all clients in turn: no client may occupy it for long.
      child
          .config()
          .setOption(
              ChannelOption.RCVBUF_ALLOCATOR,
              new AdaptiveRecvByteBufAllocator(
                      MIN_READ, BrokerLimits.READ_AT_ONCE / 2, BrokerLimits.READ_AT_ONCE)
                  .maxMessagesPerRead(1));
      child.attr(FILTERED).set(true);
      child.pipeline().addFirst(new Furnisher());
      ctx.fireChannelRead(message);
    }

    /** Handles a failed accept, such as when file descriptors run out, by retrying. */
    @Override
    public void exceptionCaught(ChannelHandlerContext ctx, Throwable cause) {
      broker.refusals.add(
          "connection not accepted", Refusals.shown(String.valueOf(cause.getMessage())));
      pause(ctx, ACCEPT_AGAIN_AFTER_MS);
    }

    private boolean isTooMuch(SocketAddress from) {
      return from instanceof InetSocketAddress address
          && !rate.accepts(
              address.getAddress(),
              broker.pending.isKnown(address.getAddress()),
              broker.nowMicros());
    }

    private static void pause(ChannelHandlerContext ctx, long milliseconds) {
      ctx.channel().config().setAutoRead(false);
      ctx.executor()
          .schedule(
              () -> ctx.channel().config().setAutoRead(true), milliseconds, TimeUnit.MILLISECONDS);
    }
  }

  /** Inserts the handlers before Moquette's once those exist. */
  private final class Furnisher extends ChannelInboundHandlerAdapter {
    @Override
    public void channelActive(ChannelHandlerContext ctx) {
      Outflow outflow = new Outflow(broker);
      boolean isWeb = ctx.pipeline().get(WEB_SOCKET) != null;
      ClientSession session =
          new ClientSession(broker, outflow, isWeb ? broker.webPending : broker.pending);
      Inflow inflow = new Inflow(broker, session);
      session.inflow(inflow);
      for (String unused : MOQUETTES_OBSERVERS) {
        ctx.pipeline().remove(unused);
      }
      if (encryption != null) {
        encryption.addTo(
            ctx.pipeline(),
            new TlsRecords(broker, session),
            broker.pending.isKnown(
                ((InetSocketAddress) ctx.channel().remoteAddress()).getAddress()));
      }
      ctx.pipeline().addFirst(new ReceivedBytes(session, inflow));
      if (isWeb) {
        WebConnection connection = new WebConnection(web.page(), web.origin(), session);
        ctx.pipeline()
            .addBefore(
                ctx.pipeline().context(HttpServerCodec.class).name(),
                "u2sa-web-input",
                new WebInput(broker.webTurns, connection, session));
        ctx.pipeline().addBefore("aggregator", "u2sa-web", connection);
      }
      ctx.pipeline()
          .addBefore(
              "decoder", "u2sa-framer", new PacketFramer(session, inflow, broker.unfinished));
      ctx.pipeline().addBefore("handler", "u2sa-inflow", inflow);
      ctx.pipeline().addBefore("handler", "u2sa-session", session);
      ctx.pipeline().addBefore("handler", "u2sa-outflow", outflow);
      ctx.fireChannelActive();
      ctx.pipeline().remove(this);
    }
  }

  /**
   * Stops accepting input and waits until the clients have received their pending messages. Returns
   * a lower bound on the number of undelivered messages.
   */
  int drain() {
    broker.end();
    return new ShutdownDrain(broker.clients.all(), clock).await();
  }

  /** Housekeeping, to be called about once a second. */
  void tidy() {
    broker.users().ifPresent(Users::refreshLater);
  }

  @Override
  public void close() {
    broker.close();
    if (encryption != null) {
      encryption.close();
    }
  }
}
