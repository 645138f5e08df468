package org.u2sa.core.communication;

import io.netty.channel.AdaptiveRecvByteBufAllocator;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ChannelOption;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.handler.codec.mqtt.MqttConnectReturnCode;
import io.netty.util.AttributeKey;
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
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;

/**
 * What stands between the network and Moquette: every connection passes here, is limited, says who
 * it is, and is watched. Moquette itself takes only those whom the connection filter let in.
 */
final class ConnectionFilter implements AutoCloseable {
  /** User name of anonymous clients. */
  static final String ANONYMOUS = "anonymous";

  /**
   * Beyond it Moquette would drop without a word; the connection filter drops earlier, and counts.
   */
  private static final int NEVER_UNWRITABLE = 64 << 20;

  /** Set for connections that pass here; those from before have nothing that limits them. */
  static final AttributeKey<Boolean> FILTERED = AttributeKey.valueOf("u2sa-filtered");

  private static final long ACCEPT_AGAIN_AFTER_MS = 200;

  private static final int LEAST_READ = 512;

  private static final double TOTAL_BURST_S = 0.01; // for so long a flood may hold up the others

  /** They log and count each packet, and nobody reads it. */
  private static final List<String> MOQUETTES_OBSERVERS = List.of("messageLogger", "metrics");

  private final BrokerLimits limits;
  private final MessageCodec codec;
  private final Clock clock;
  private final Refusals refusals;
  private final Users users; // null: everybody may do everything
  private final Authenticator authenticator; // null likewise
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
  private final RemoteSubscriptions subscriptions = new RemoteSubscriptions();
  private final MessageRouter router;
  private volatile boolean ending;

  /**
   * @param users the known users; null: anybody may connect without a password
   */
  ConnectionFilter(
      BrokerLimits limits, MessageCodec codec, Clock clock, Users users, Consumer<String> log) {
    this.limits = limits;
    this.codec = codec;
    this.clock = clock;
    this.users = users;
    authenticator =
        users == null || !users.havePasswords() ? null : new Authenticator(users, clock);
    refusals = new Refusals(log);
    retained = new RetainedTable(limits);
    router = new MessageRouter(subscriptions, retained, connections);
    questions = new Allowance.PerUser(limits.clientQuestionsPerSecond());
    double totalPerS = limits.totalMessagesPerSecond();
    beyondShares = new Allowance(totalPerS, TOTAL_BURST_S * totalPerS, clock.micros());
  }

  private static byte[] newPass() {
    byte[] random = new byte[32];
    new SecureRandom().nextBytes(random);
    return Base64.getEncoder().encode(random);
  }

  /** What the connection filter gives those it lets in, in place of a password. */
  String pass() {
    return new String(pass, StandardCharsets.US_ASCII);
  }

  /**
   * For Moquette: whether the connection filter let this one in.
   *
   * @throws StartingException if it did not, because the connection filter was not there yet: the
   *     connection ends without an answer and its client comes again, where "wrong password" would
   *     be final
   */
  boolean letIn(byte[] password) {
    if (password == null || !MessageDigest.isEqual(pass, password)) {
      throw new StartingException();
    }
    return true;
  }

  /** Nothing is wrong, so without a stack trace: Moquette writes one to its log. */
  static final class StartingException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StartingException() {
      super("the broker is only starting; the client will come again", null, false, false);
    }
  }

  /** Goes in front of the listening socket's pipeline, which hands on each new connection. */
  final class Acceptor extends ChannelInboundHandlerAdapter {
    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      Channel child = (Channel) message;
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
      // One thread reads all clients in turn: none is to keep it long.
      child
          .config()
          .setOption(
              ChannelOption.RCVBUF_ALLOCATOR,
              new AdaptiveRecvByteBufAllocator(
                      LEAST_READ, BrokerLimits.READ_AT_ONCE / 2, BrokerLimits.READ_AT_ONCE)
                  .maxMessagesPerRead(1));
      child.attr(FILTERED).set(true);
      child.pipeline().addFirst(new Furnisher());
      ctx.fireChannelRead(message);
    }

    /** Accepting failed, as it does while the process has no file descriptor left: tries again. */
    @Override
    public void exceptionCaught(ChannelHandlerContext ctx, Throwable cause) {
      refusals.add("connection not accepted", Refusals.shown(String.valueOf(cause.getMessage())));
      ctx.channel().config().setAutoRead(false);
      ctx.executor()
          .schedule(
              () -> ctx.channel().config().setAutoRead(true),
              ACCEPT_AGAIN_AFTER_MS,
              TimeUnit.MILLISECONDS);
    }
  }

  /** Puts the handlers in front of Moquette's, once those are there. */
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

  /** What came of {@link #enter}. */
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

    /** Why the client may not be entered. */
    String reason() {
      return reason;
    }

    /** What the client is told; where waiting helps, that it may come again. */
    MqttConnectReturnCode answer() {
      return answer;
    }
  }

  /** An ID for a connection: never the same twice. */
  String newConnection() {
    return "connection-" + connectionsSoFar.incrementAndGet();
  }

  /** Enters a client under its ID, in the place of an older connection of the same client. */
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
    if (before != null) { // a client that comes back before its old connection was found dead
      before.replaced();
    }
    return Entry.FREE;
  }

  private long ofUser(String name) {
    return clients.values().stream().filter(other -> other.name().equals(name)).count();
  }

  /** Moquette is ready for the packets of a connection. */
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

  /** What the broker retains. */
  RetainedTable retained() {
    return retained;
  }

  /** The subscriptions of remote clients. */
  RemoteSubscriptions subscriptions() {
    return subscriptions;
  }

  /** The way of messages. */
  MessageRouter router() {
    return router;
  }

  /** How many questions each user may still ask. */
  Allowance.PerUser questions() {
    return questions;
  }

  /**
   * Messages of all clients together, beyond each one's share. For the one thread that reads them.
   */
  Allowance beyondShares() {
    return beyondShares;
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

  /** The known users; empty: anybody may connect without a password. */
  Optional<Users> users() {
    return Optional.ofNullable(users);
  }

  /** Where passwords are checked; there if {@link #users} have some. */
  Authenticator authenticator() {
    return authenticator;
  }

  /** What waits at the broker for the rest of its packet. For the network's thread. */
  MemoryBudget<ClientSession> unfinished() {
    return unfinished;
  }

  /** What clients have not read or acknowledged. For the network's thread. */
  MemoryBudget<ClientSession> unsent() {
    return unsent;
  }

  /** Takes note of a message that is kept until each of its subscribers has acknowledged it. */
  void keep(int bytes) {
    kept.addAndGet(bytes);
  }

  /** Bytes of {@link #keep}, so far. */
  long kept() {
    return kept.get();
  }

  PendingConnections<ClientSession> pending() {
    return pending;
  }

  /** Counts a message that a client was too slow for. */
  void dropped(String client) {
    dropped.incrementAndGet();
    refusals.add("message to a slow client dropped", client);
  }

  /** Whether nothing new is taken any more. */
  boolean isEnding() {
    return ending;
  }

  /**
   * Takes nothing new any more, and waits until the clients have taken what was sent to them.
   * Returns how many messages at least they have not taken.
   */
  int drain() {
    ending = true;
    return new ShutdownDrain(clients.values(), clock).await();
  }

  /** Messages dropped because a client was too slow, so far. */
  long dropped() {
    return dropped.get();
  }

  /** To be called about every second. */
  void tidy() {
    if (users != null) {
      users.refresh();
    }
  }

  /** Connections at this moment. */
  int open() {
    return open.get();
  }

  @Override
  public void close() {
    if (authenticator != null) {
      authenticator.close();
    }
  }
}
