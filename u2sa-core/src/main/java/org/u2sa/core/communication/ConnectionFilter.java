package org.u2sa.core.communication;

import io.netty.channel.AdaptiveRecvByteBufAllocator;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ChannelOption;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.handler.codec.mqtt.MqttConnectReturnCode;
import io.netty.util.AttributeKey;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.core.communication.access.Authenticator;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.communication.limit.AcceptRate;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.limit.CostlyTime;
import org.u2sa.core.communication.limit.PendingConnections;
import org.u2sa.core.communication.routing.RemoteSubscriptions;
import org.u2sa.core.communication.routing.RetainedTable;
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

  private static final long ACCEPT_AGAIN_AFTER_MS = 200;

  /** Connections accepted per second from unknown networks, see {@link AcceptRate}. */
  static final double ACCEPTED_PER_S = 2_000.0;

  static final double ENCRYPTED_PER_S = 200.0; // each costs milliseconds

  /** Further connections refused per second; the rest wait in the listen backlog. */
  private static final double REFUSED_PER_S = 20_000.0;

  private static final double REFUSED_AT_ONCE = 200.0;

  private static final long REFUSE_AGAIN_AFTER_MS = 10;

  private static final int MIN_READ = 512;

  private static final double TOTAL_BURST_S = 0.01; // how long a flood may delay other clients

  /** Moquette handlers that log and count each packet, unused here. */
  private static final List<String> MOQUETTES_OBSERVERS = List.of("messageLogger", "metrics");

  private final BrokerLimits limits;
  private final MessageCodec codec;
  private final Clock clock;
  private final Refusals refusals;
  private final Users users; // null grants everyone full access
  private final Authenticator authenticator; // null likewise
  private final Encryption encryption; // null: plain text
  private final byte[] pass = newPass();
  private final AtomicLong kept = new AtomicLong();
  private final PendingConnections<ClientSession> pending = new PendingConnections<>();
  private final AtomicInteger open = new AtomicInteger();
  private final AtomicLong dropped = new AtomicLong();
  private final Map<String, ClientSession> clients = new ConcurrentHashMap<>();
  private final Map<String, ClientSession> connections =
      new ConcurrentHashMap<>(); // Moquette's view
  private final AtomicLong connectionsSoFar = new AtomicLong();
  private final RetainedTable retained;
  private final Allowance.PerUser questions;
  private final MemoryBudget<ClientSession> unfinished = // touched by the network's thread only
      MemoryBudget.ofClients(
          8, 64 << 20, "connection closed, too many bytes wait for the rest of a packet");
  private final MemoryBudget<ClientSession> unsent = // touched by the network's thread only
      MemoryBudget.ofClients(4, 256 << 20, ClientSession.TOO_SLOW);
  private final Allowance beyondShares; // touched by the network's thread only
  private final CostlyTime costlyTime; // touched by the network's thread only
  private final RemoteSubscriptions subscriptions = new RemoteSubscriptions();
  private final MessageRouter router;
  private volatile boolean ending;

  /** Without encryption. */
  ConnectionFilter(
      BrokerLimits limits, MessageCodec codec, Clock clock, Users users, Consumer<String> log) {
    this(limits, codec, clock, users, null, log);
  }

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
    this.limits = limits;
    this.encryption = encryption;
    this.codec = codec;
    this.clock = clock;
    this.users = users;
    refusals = new Refusals(log);
    authenticator =
        users == null || !users.havePasswords()
            ? null
            : new Authenticator(users, clock, what -> refusals.add("log-in failed", what));
    retained = new RetainedTable(limits);
    router = new MessageRouter(subscriptions, retained, connections);
    questions = new Allowance.PerUser(limits.clientQuestionsPerSecond());
    double totalPerS = limits.totalMessagesPerSecond();
    beyondShares = new Allowance(totalPerS, TOTAL_BURST_S * totalPerS, clock.micros());
    costlyTime = new CostlyTime(clock.micros());
  }

  private static byte[] newPass() {
    byte[] random = new byte[32];
    new SecureRandom().nextBytes(random);
    return Base64.getEncoder().encode(random);
  }

  /** Pass that replaces the password of admitted connections. */
  String pass() {
    return new String(pass, StandardCharsets.US_ASCII);
  }

  /**
   * Called by Moquette: returns whether this filter admitted the connection.
   *
   * @throws StartingException if not, because the filter was not installed yet: the connection
   *     closes without an answer and the client retries, whereas "wrong password" would be final
   */
  boolean letIn(byte[] password) {
    if (password == null || !MessageDigest.isEqual(pass, password)) {
      throw new StartingException();
    }
    return true;
  }

  /** Carries no stack trace, because Moquette would log it although nothing is wrong. */
  static final class StartingException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StartingException() {
      super("the broker is only starting; the client will come again", null, false, false);
    }
  }

  /** First handler of the listening socket's pipeline; receives each new connection. */
  final class Acceptor extends ChannelInboundHandlerAdapter {
    private final AcceptRate rate =
        new AcceptRate(encryption == null ? ACCEPTED_PER_S : ENCRYPTED_PER_S, nowMicros());
    private final Allowance refused = new Allowance(REFUSED_PER_S, REFUSED_AT_ONCE, nowMicros());

    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      Channel child = (Channel) message;
      if (isTooMuch(child.remoteAddress())) { // before anything is built for it
        refusals.add(
            "connection refused, too many a second", String.valueOf(child.remoteAddress()));
        child.unsafe().closeForcibly();
        refused.take(1.0, nowMicros());
        if (!refused.isOpen(nowMicros())) {
          pause(ctx, REFUSE_AGAIN_AFTER_MS);
        }
        return;
      }
      // Pending and admitted connections are counted apart; this bounds both together.
      if (open.incrementAndGet() > limits.clientsAtMost() + 2 * BrokerLimits.PENDING || ending) {
        open.decrementAndGet();
        refusals.add(
            "connection refused, " + (ending ? "the broker ends" : "too many"),
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
      // One thread reads all clients in turn: none may occupy it for long.
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
      refusals.add("connection not accepted", Refusals.shown(String.valueOf(cause.getMessage())));
      pause(ctx, ACCEPT_AGAIN_AFTER_MS);
    }

    private boolean isTooMuch(SocketAddress from) {
      return from instanceof InetSocketAddress address
          && !rate.accepts(
              address.getAddress(), pending.isKnown(address.getAddress()), nowMicros());
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
      Outflow outflow = new Outflow(ConnectionFilter.this);
      ClientSession session = new ClientSession(ConnectionFilter.this, outflow);
      Inflow inflow = new Inflow(ConnectionFilter.this, session);
      session.inflow(inflow);
      for (String unused : MOQUETTES_OBSERVERS) {
        ctx.pipeline().remove(unused);
      }
      if (encryption != null) {
        encryption.addTo(
            ctx.pipeline(),
            new TlsRecords(ConnectionFilter.this, session),
            pending.isKnown(((InetSocketAddress) ctx.channel().remoteAddress()).getAddress()));
      }
      ctx.pipeline().addFirst(new ReceivedBytes(session, inflow));
      ctx.pipeline()
          .addBefore("decoder", "u2sa-framer", new PacketFramer(session, inflow, unfinished));
      ctx.pipeline().addBefore("handler", "u2sa-inflow", inflow);
      ctx.pipeline().addBefore("handler", "u2sa-session", session);
      ctx.pipeline().addBefore("handler", "u2sa-outflow", outflow);
      ctx.fireChannelActive();
      ctx.pipeline().remove(this);
    }
  }

  /** Result of {@link #enter}. */
  enum Entry {
    FREE("", MqttConnectReturnCode.CONNECTION_ACCEPTED),
    FULL("too many connections", MqttConnectReturnCode.CONNECTION_REFUSED_SERVER_UNAVAILABLE),
    FULL_FOR_USER(
        "too many connections of one user",
        MqttConnectReturnCode.CONNECTION_REFUSED_SERVER_UNAVAILABLE),
    ANOTHERS_ID(
        "the client ID is another user's",
        MqttConnectReturnCode.CONNECTION_REFUSED_IDENTIFIER_REJECTED);

    private final String reason;
    private final MqttConnectReturnCode answer;

    Entry(String reason, MqttConnectReturnCode answer) {
      this.reason = reason;
      this.answer = answer;
    }

    /** Reason for refusing the client. */
    String reason() {
      return reason;
    }

    /** Return code for the client; a temporary one where retrying may help. */
    MqttConnectReturnCode answer() {
      return answer;
    }
  }

  /** Creates a unique connection ID. */
  String newConnection() {
    return "connection-" + connectionsSoFar.incrementAndGet();
  }

  /** Registers a client under its ID, replacing an older connection of the same client. */
  synchronized Entry enter(String clientId, ClientSession session) {
    ClientSession before = clients.get(clientId);
    if (before != null && !before.name().equals(session.name())) {
      return Entry.ANOTHERS_ID;
    }
    int others = clients.size() - (before == null ? 0 : 1);
    boolean keepFree = users != null && !session.isOperator();
    if (others >= (keepFree ? limits.clientsBesidesOperators() : limits.clientsAtMost())) {
      return Entry.FULL;
    }
    if (users != null
        && ofUser(session.name()) - (before == null ? 0 : 1) >= limits.clientsPerUser()) {
      return Entry.FULL_FOR_USER;
    }
    clients.put(clientId, session);
    connections.put(session.connection(), session);
    if (before != null) { // reconnected before its old connection was detected as dead
      before.replaced();
    }
    return Entry.FREE;
  }

  private long ofUser(String name) {
    return clients.values().stream().filter(other -> other.name().equals(name)).count();
  }

  /** Called when Moquette is ready for a connection's packets. */
  void connected(String connection) {
    ClientSession session = connections.get(connection);
    if (session != null) {
      session.connected();
    }
  }

  void leave(String clientId, ClientSession session) {
    clients.remove(clientId, session);
    connections.remove(session.connection());
    subscriptions.remove(session.connection());
  }

  /** The broker's retained messages. */
  RetainedTable retained() {
    return retained;
  }

  /** The subscriptions of remote clients. */
  RemoteSubscriptions subscriptions() {
    return subscriptions;
  }

  /** The message router. */
  MessageRouter router() {
    return router;
  }

  /** Per-user allowances for queries. */
  Allowance.PerUser questions() {
    return questions;
  }

  /**
   * Shared allowance for messages of all clients beyond their own shares. For the network's thread
   * only.
   */
  Allowance beyondShares() {
    return beyondShares;
  }

  /** The network thread's time for long messages and grids of all clients. For that thread only. */
  CostlyTime costlyTime() {
    return costlyTime;
  }

  BrokerLimits limits() {
    return limits;
  }

  MessageCodec codec() {
    return codec;
  }

  long nowMicros() {
    return clock.micros();
  }

  Refusals refusals() {
    return refusals;
  }

  /** The known users; empty if anyone may connect without a password. */
  Optional<Users> users() {
    return Optional.ofNullable(users);
  }

  /** The authenticator; present if {@link #users} have passwords. */
  Authenticator authenticator() {
    return authenticator;
  }

  /** Memory budget for incomplete packets. For the network's thread. */
  MemoryBudget<ClientSession> unfinished() {
    return unfinished;
  }

  /**
   * Memory budget for messages that clients have not read or acknowledged. For the network's
   * thread.
   */
  MemoryBudget<ClientSession> unsent() {
    return unsent;
  }

  /** Counts a message that is kept until all its subscribers have acknowledged it. */
  void keep(int bytes) {
    kept.addAndGet(bytes);
  }

  /** Total bytes passed to {@link #keep}. */
  long kept() {
    return kept.get();
  }

  PendingConnections<ClientSession> pending() {
    return pending;
  }

  /** Counts a message dropped because a client was too slow. */
  void dropped(String client) {
    dropped.incrementAndGet();
    refusals.add("message to a slow client dropped", client);
  }

  /** Whether the broker is shutting down and accepts nothing new. */
  boolean isEnding() {
    return ending;
  }

  /**
   * Stops accepting input and waits until the clients have received what was sent to them. Returns
   * a lower bound on the number of undelivered messages.
   */
  int drain() {
    ending = true;
    return new ShutdownDrain(clients.values(), clock).await();
  }

  /** Number of messages dropped because a client was too slow. */
  long dropped() {
    return dropped.get();
  }

  /** Housekeeping, to be called about once a second. */
  void tidy() {
    if (users != null) {
      users.refresh();
    }
  }

  @Override
  public void close() {
    if (authenticator != null) {
      authenticator.close();
    }
    if (encryption != null) {
      encryption.close();
    }
  }
}
