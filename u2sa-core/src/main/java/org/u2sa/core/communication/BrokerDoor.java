package org.u2sa.core.communication;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ChannelOption;
import io.netty.channel.WriteBufferWaterMark;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.interfaces.Clock;
import org.u2sa.messages.MessageCodec;

/**
 * What stands between the network and Moquette: every connection passes here, is limited, says who
 * it is, and is watched. Moquette itself takes only those whom the door let in.
 */
final class BrokerDoor implements AutoCloseable {
  /** As whom a client goes that need not say its name. */
  static final String ANONYMOUS = "anonymous";

  /** Beyond it Moquette would drop without a word; the door drops earlier, and counts. */
  private static final int NEVER_UNWRITABLE = 64 << 20;

  private final BrokerLimits limits;
  private final MessageCodec codec;
  private final Clock clock;
  private final Refusals refusals;
  private final Users users; // null: everybody may do everything
  private final LoginDesk desk; // null likewise
  private final byte[] pass = newPass();
  private final Backlog backlog = new Backlog();
  private final Strangers strangers = new Strangers();
  private final AtomicInteger open = new AtomicInteger();
  private final AtomicLong unsent = new AtomicLong();
  private final Map<String, ClientGate> clients = new ConcurrentHashMap<>();
  private final Set<String> retainedTopics = ConcurrentHashMap.newKeySet();
  private volatile boolean ending;

  /**
   * @param users who may come; null: everybody, without a password
   */
  BrokerDoor(
      BrokerLimits limits, MessageCodec codec, Clock clock, Users users, Consumer<String> log) {
    this.limits = limits;
    this.codec = codec;
    this.clock = clock;
    this.users = users;
    desk = users == null || !users.havePasswords() ? null : new LoginDesk(users, clock);
    refusals = new Refusals(log);
  }

  private static byte[] newPass() {
    byte[] random = new byte[32];
    new SecureRandom().nextBytes(random);
    return Base64.getEncoder().encode(random);
  }

  /** What the door gives those it lets in, in place of a password. */
  String pass() {
    return new String(pass, StandardCharsets.US_ASCII);
  }

  /**
   * For Moquette: whether the door let this one in.
   *
   * @throws StartingException if it did not, because the door was not there yet: the connection
   *     ends without an answer and its client comes again, where "wrong password" would be final
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
      if (open.incrementAndGet() > limits.clients() || ending) {
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
      child.pipeline().addFirst(new Furnisher());
      ctx.fireChannelRead(message);
    }
  }

  /** Puts the handlers in front of Moquette's, once those are there. */
  private final class Furnisher extends ChannelInboundHandlerAdapter {
    @Override
    public void channelActive(ChannelHandlerContext ctx) {
      Outflow outflow = new Outflow(BrokerDoor.this);
      ClientGate gate = new ClientGate(BrokerDoor.this, outflow);
      Inflow inflow = new Inflow(BrokerDoor.this, gate);
      gate.inflow(inflow);
      ctx.pipeline().addFirst(new FirstBytes(gate));
      ctx.pipeline().addBefore("handler", "u2sa-inflow", inflow);
      ctx.pipeline().addBefore("handler", "u2sa-gate", gate);
      ctx.pipeline().addBefore("handler", "u2sa-outflow", outflow);
      ctx.pipeline().addBefore("handler", "u2sa-retain-flag", new RetainFlag(retainedTopics));
      ctx.fireChannelActive();
      ctx.pipeline().remove(this);
    }
  }

  /**
   * Enters a client under its ID.
   *
   * @return why it may not be entered; empty if it was
   */
  Optional<String> enter(String clientId, ClientGate gate) {
    long ofUser =
        clients.values().stream().filter(other -> other.name().equals(gate.name())).count();
    if (users != null && ofUser >= limits.clientsPerUser()) {
      return Optional.of("too many connections of one user");
    }
    ClientGate before = clients.putIfAbsent(clientId, gate);
    if (before != null && !before.name().equals(gate.name())) {
      return Optional.of("the client ID is another user's");
    }
    if (before != null) { // a client that comes back before its old connection was found dead
      clients.put(clientId, gate);
    }
    return Optional.empty();
  }

  /** Moquette is ready for the client's packets. */
  void connected(String clientId) {
    ClientGate gate = clients.get(clientId);
    if (gate != null) {
      gate.connected();
    }
  }

  void leave(String clientId, ClientGate gate) {
    clients.remove(clientId, gate);
  }

  /** Whether a topic may be retained: those that are already, and new ones while there is room. */
  boolean mayRetain(String topic) {
    return retainedTopics.contains(topic)
        || retainedTopics.size() < BrokerLimits.RETAINED_TOPICS && retainedTopics.add(topic);
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

  /** Who may come; empty: everybody, without a password. */
  Optional<Users> users() {
    return Optional.ofNullable(users);
  }

  /** Where passwords are checked; there if {@link #users} have some. */
  LoginDesk desk() {
    return desk;
  }

  Backlog backlog() {
    return backlog;
  }

  Strangers strangers() {
    return strangers;
  }

  /** Counts a message that a client was too slow for. */
  void unsent(String client) {
    unsent.incrementAndGet();
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
  int awaitLastWords() {
    ending = true;
    return new LastWords(clients.values(), clock).await();
  }

  /** Messages dropped because a client was too slow, or that Moquette lost, so far. */
  long dropped() {
    return unsent.get() + refusals.of(LOST);
  }

  private static final String LOST = "message lost in the broker";

  /** To be called about every second. */
  void tidy() {
    long lost = backlog.settle();
    for (long i = 0; i < lost; i++) {
      refusals.add(LOST, "its queues were full");
    }
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
    if (desk != null) {
      desk.close();
    }
  }
}
