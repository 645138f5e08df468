package org.u2sa.core.communication;

import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.mqtt.MqttConnectMessage;
import io.netty.handler.codec.mqtt.MqttConnectReturnCode;
import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttMessageType;
import io.netty.handler.codec.mqtt.MqttPubAckMessage;
import io.netty.util.ReferenceCountUtil;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.communication.access.ConnectRequest;
import org.u2sa.core.communication.access.LocalAccount;
import org.u2sa.core.communication.access.LoginApplication;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.access.SourceNames;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.limit.PendingConnections;
import org.u2sa.core.communication.routing.Publication;
import org.u2sa.core.communication.web.WebSession;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.mqtt.ClientIds;

/**
 * One client's session: authenticates the client, then filters each of its packets before Moquette
 * sees it. Confined to its connection's thread.
 */
final class ClientSession extends ChannelInboundHandlerAdapter
    implements Client, AnonymousOutput.Recipient, Inflow.Gate, WebSession {
  private enum Stage {
    STRANGER,
    CHECKED, // password check pending
    IN,
    OUT
  }

  private final BrokerState broker;
  private final Outflow outflow;
  private final PendingConnections<Client> pending; // of its port
  private final String connection;
  private final Allowance pings;
  private Inflow inflow;
  private Stage stage = Stage.STRANGER;
  private PacketFilter packets; // set on admission, like the rules
  private PacketRules rules;
  private ClientSubscriptions subscriptions;
  private boolean isBudgeted; // the client's memory is counted
  private ConnectRequest.Will will; // null if no will, or already published
  private boolean hasNews; // packets passed to Moquette since the last read-complete
  private String clientId = "";
  private volatile String name = LocalAccount.ANONYMOUS;
  private User user; // null: anonymous
  private boolean isAnonymous; // without the token of the account, where there is one
  private InetAddress from;
  private long since;
  private ScheduledFuture<?> watch;
  private volatile boolean connected; // Moquette has finished its part
  private volatile ChannelHandlerContext context;

  ClientSession(BrokerState broker, Outflow outflow) {
    this(broker, outflow, broker.pending);
  }

  /**
   * @param pending the connections of its port that have not identified themselves
   */
  ClientSession(BrokerState broker, Outflow outflow, PendingConnections<Client> pending) {
    this.broker = broker;
    this.outflow = outflow;
    this.pending = pending;
    connection = broker.clients.newConnection();
    pings =
        new Allowance(
            BrokerLimits.PINGS_PER_SECOND, BrokerLimits.PINGS_PER_SECOND, broker.nowMicros());
  }

  void inflow(Inflow before) {
    inflow = before;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String label() {
    return Refusals.shown(ClientIds.shown(clientId));
  }

  @Override
  public boolean isOperator() {
    return user != null && user.roles().contains(AccessRole.OPERATOR);
  }

  @Override
  public String connection() {
    return connection;
  }

  @Override
  public boolean isInTurn(Object packet) {
    if (subscriptions == null || !(packet instanceof MqttMessage message)) {
      return true;
    }
    boolean isPing =
        message.fixedHeader() != null
            && message.fixedHeader().messageType() == MqttMessageType.PINGREQ;
    return isPing ? mayPing() : subscriptions.isInTurn(message);
  }

  @Override
  public boolean isAwaited(Object packet) {
    return packet instanceof MqttPubAckMessage acknowledgement
        && outflow.isAwaited(acknowledgement.variableHeader().messageId());
  }

  @Override
  public boolean isAnonymous() {
    return isAnonymous;
  }

  private boolean mayPing() {
    boolean may = pings.isOpen(broker.nowMicros());
    if (may) {
      pings.take(1.0);
    }
    return may;
  }

  @Override
  public void replaced() {
    ChannelHandlerContext ctx = context;
    Client.execute(
        ctx.executor(),
        () -> {
          will = null;
          stage = Stage.OUT;
          ctx.close();
        });
  }

  @Override
  public boolean isReady() {
    return stage != Stage.CHECKED && (stage != Stage.IN || connected) && !outflow.owesAnswers();
  }

  @Override
  public void connected() {
    connected = true;
  }

  @Override
  public Future<Client.Owed> owed() {
    return context.executor().submit(outflow::owed);
  }

  @Override
  public void handlerAdded(ChannelHandlerContext ctx) {
    context = ctx;
    since = broker.nowMicros();
    from = ((InetSocketAddress) ctx.channel().remoteAddress()).getAddress();
    for (Client longest : pending.add(this, from)) {
      longest.putOutFor("pending connection closed in favour of a newer one");
    }
    watch = ctx.executor().scheduleAtFixedRate(() -> look(ctx), 1, 1, TimeUnit.SECONDS);
  }

  @Override
  public boolean deliver(Publication publication, boolean eachMatters) {
    if (isAnonymous) { // it slows no publisher down
      broker.anonymousOutput.add(this, publication, eachMatters, context.executor());
      return false;
    }
    return deliverNow(publication, eachMatters);
  }

  @Override
  public boolean deliverNow(Publication publication, boolean eachMatters) {
    ChannelHandlerContext ctx = context;
    if (stage != Stage.IN) {
      return false;
    }
    String why = outflow.deliver(ctx, publication, eachMatters);
    budget(ctx);
    if (why != null) {
      putOut(ctx, BrokerState.TOO_SLOW, why);
    }
    return why == null && Outflow.isBehind(ctx);
  }

  private void budget(ChannelHandlerContext ctx) {
    long kept = outflow.kept(ctx);
    if (kept > BrokerLimits.BEHIND_BYTES || isBudgeted) {
      isBudgeted = kept > BrokerLimits.BEHIND_BYTES;
      broker.unsent.set(this, isBudgeted ? kept : 0);
    }
  }

  @Override
  public void subscriberIsBehind(boolean behind) {
    inflow.subscriberIsBehind(behind);
  }

  @Override
  public void acknowledge(int packet) {
    outflow.acknowledge(context, packet);
  }

  @Override
  public void acknowledged(int packet) {
    outflow.acknowledged(packet);
  }

  @Override
  public void answer(MqttMessage answer) {
    outflow.answer(context, answer);
  }

  @Override
  public boolean isPending() {
    return stage == Stage.STRANGER;
  }

  @Override
  public boolean isOut() {
    return stage == Stage.OUT;
  }

  @Override
  public void putOutFor(String kind) {
    ChannelHandlerContext ctx = context;
    Client.execute(ctx.executor(), () -> putOut(ctx, kind, ""));
  }

  @Override
  public void putOut(String why) {
    putOut(why, "");
  }

  @Override
  public void putOut(String kind, String details) {
    putOut(context, kind, details);
  }

  private void putOut(ChannelHandlerContext ctx, String kind, String details) {
    if (stage != Stage.OUT) {
      stage = Stage.OUT;
      broker.refusals.add(kind, who() + (details.isEmpty() ? "" : ", " + details));
      // Bypasses the encryption, which would wait until the client has read its close_notify.
      ctx.pipeline().firstContext().close();
    }
  }

  private String who() {
    return String.format(
        "user %s, client %s, from %s",
        Refusals.shown(name), Refusals.shown(ClientIds.shown(clientId)), from.getHostAddress());
  }

  private void look(ChannelHandlerContext ctx) {
    if (stage == Stage.STRANGER
        && broker.nowMicros() - since > 1_000 * BrokerLimits.CONNECT_WITHIN_MS) {
      putOut(ctx, "connection closed: the client did not identify itself", "");
    } else if (stage == Stage.IN) {
      outflow.tooSlow(ctx).ifPresent(why -> putOut(ctx, BrokerState.TOO_SLOW, why));
      budget(ctx);
      if (user != null
          && !broker.users().flatMap(all -> all.named(name)).equals(Optional.of(user))) {
        putOut(ctx, "client disconnected, its user was changed or removed", "");
      }
    }
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    MqttMessage packet = (MqttMessage) message;
    boolean handedOn = false;
    try {
      if (stage == Stage.OUT) {
        return;
      }
      if (packet.decoderResult() != null && packet.decoderResult().isFailure()
          || packet.fixedHeader() == null) {
        Throwable cause = packet.decoderResult() == null ? null : packet.decoderResult().cause();
        putOut(
            ctx,
            ConnectionFault.MALFORMED,
            cause == null ? "" : Refusals.shown("" + cause.getMessage()));
      } else if (stage == Stage.STRANGER) {
        hasNews = true; // connect passes it on
        connect(ctx, packet);
      } else {
        handedOn = packets.examine(ctx, packet);
        if (packet.fixedHeader().messageType() == MqttMessageType.DISCONNECT) {
          // MQTT ignores all packets after DISCONNECT (3.14.4) and discards the will.
          stage = Stage.OUT;
          will = null;
        }
      }
    } finally {
      hasNews |= handedOn;
      if (!handedOn) {
        ReferenceCountUtil.release(message);
      }
    }
  }

  /**
   * Moquette then checks the client's queue on its own thread. If every packet bypassed Moquette,
   * the queue is empty, and waking that thread would only delay the message.
   */
  @Override
  public void channelReadComplete(ChannelHandlerContext ctx) {
    if (hasNews || stage != Stage.IN) {
      hasNews = false;
      ctx.fireChannelReadComplete();
    }
  }

  private void connect(ChannelHandlerContext ctx, MqttMessage packet) {
    if (!(packet instanceof MqttConnectMessage connect)) {
      putOut(ctx, ConnectionFault.MALFORMED, "the first packet is not a CONNECT");
      return;
    }
    ConnectRequest said = ConnectRequest.of(connect, broker.pass());
    clientId = said.clientId();
    Optional<ConnectRequest.Fault> fault = said.fault();
    if (fault.isPresent()) {
      refuse(ctx, fault.get().answer(), fault.get().reason());
    } else if (broker.users().isEmpty()) {
      admit(ctx, said);
    } else if (!broker.users().get().havePasswords()) {
      loginLocally(ctx, said, broker.users().get());
    } else if (said.user().isEmpty()) {
      refuse(ctx, MqttConnectReturnCode.CONNECTION_REFUSED_NOT_AUTHORIZED, "it gives no user name");
    } else {
      name = said.user();
      stage = Stage.CHECKED;
      inflow.hold();
      broker.authenticator.check(
          name,
          said.password(),
          from,
          verdict -> Client.execute(ctx.executor(), () -> judged(ctx, said, verdict)));
    }
  }

  private void loginLocally(ChannelHandlerContext ctx, ConnectRequest said, Users users) {
    Optional<User> known = users.ofAccount(said.user(), said.password());
    if (known.isEmpty()) {
      refuse(
          ctx, MqttConnectReturnCode.CONNECTION_REFUSED_BAD_USER_NAME_OR_PASSWORD, "wrong token");
      return;
    }
    user = known.get();
    name = user.name();
    isAnonymous = said.user().isEmpty();
    if (isOperator()) { // the account's user, not anonymous
      pending.proven(this);
    }
    admit(ctx, said);
  }

  private void judged(
      ChannelHandlerContext ctx, ConnectRequest said, LoginApplication.Verdict verdict) {
    if (stage != Stage.CHECKED) {
      return; // disconnected in the meantime
    }
    if (verdict.user().isEmpty()) {
      refuse(
          ctx,
          verdict.isFinal()
              ? MqttConnectReturnCode.CONNECTION_REFUSED_BAD_USER_NAME_OR_PASSWORD
              : MqttConnectReturnCode.CONNECTION_REFUSED_SERVER_UNAVAILABLE,
          verdict.reason());
      return;
    }
    user = verdict.user().get();
    pending.proven(this);
    admit(ctx, said);
    ctx.fireChannelReadComplete();
  }

  private void admit(ChannelHandlerContext ctx, ConnectRequest said) {
    PacketRules its = new PacketRules(broker, user, clientId);
    Optional<ConnectRequest.Will> last = said.will();
    Optional<String> foreign = last.flatMap(one -> its.refusalOfSystem(one.topic()));
    if (foreign.isPresent()) { // refuse a client of a foreign system immediately
      refuse(ctx, MqttConnectReturnCode.CONNECTION_REFUSED_NOT_AUTHORIZED, foreign.get());
      return;
    }
    ClientTable.Entry entry = broker.clients.enter(clientId, this);
    if (entry != ClientTable.Entry.FREE) {
      refuse(ctx, entry.answer(), entry.reason());
      return;
    }
    stage = Stage.IN;
    rules = its;
    subscriptions = new ClientSubscriptions(broker, its, name, connection);
    packets = new PacketFilter(broker, its, subscriptions, who(), this);
    inflow.hold();
    pending.remove(this);
    outflow.admitted(user, clientId, isAnonymous);
    // A rejected will does not reject the client: every U2SA client has a will, even an observer.
    Optional<String> refused = last.flatMap(its::refusalOfWill);
    refused.ifPresent(this::willRefused);
    will = refused.isPresent() ? null : last.orElse(null);
    ctx.fireChannelRead(said.forMoquette(connection, name));
  }

  private void willRefused(String why) {
    broker.refusals.add("will refused, " + why, who());
  }

  private void publishWill() {
    ConnectRequest.Will last = will;
    will = null;
    if (last == null || broker.isEnding()) {
      return;
    }
    if (!rules.mayName(last)) {
      willRefused(SourceNames.TAKEN);
      return;
    }
    if (last.isRetained()) {
      rules.retain(last).ifPresent(this::willRefused); // present subscribers receive it regardless
    }
    if (last.eachMatters()) {
      broker.keep(last.payload().length);
    }
    broker.router.route(
        last.topic(), Unpooled.wrappedBuffer(last.payload()), last.eachMatters(), this);
  }

  private void refuse(ChannelHandlerContext ctx, MqttConnectReturnCode code, String why) {
    stage = Stage.OUT;
    broker.refusals.add("log-in refused, " + why, who());
    ctx.writeAndFlush(MqttMessageBuilders.connAck().returnCode(code).build())
        .addListener(ChannelFutureListener.CLOSE);
  }

  @Override
  public void channelInactive(ChannelHandlerContext ctx) {
    stage = Stage.OUT;
    publishWill();
    ctx.fireChannelInactive();
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext ctx) {
    stage = Stage.OUT;
    watch.cancel(false);
    pending.remove(this);
    broker.unsent.set(this, 0);
    broker.leave(clientId, this);
    if (rules != null) {
      rules.leave();
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext ctx, Throwable cause) {
    ConnectionFault fault = ConnectionFault.of(cause);
    if (stage == Stage.IN && fault.isLoss()) {
      stage = Stage.OUT; // its will reports the loss
      ctx.close();
    } else {
      putOut(ctx, fault.kind(), fault.words());
    }
  }
}
