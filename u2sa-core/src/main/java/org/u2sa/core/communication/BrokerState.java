package org.u2sa.core.communication;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.core.communication.access.Authenticator;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.access.SourceNames;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.limit.CostlyTime;
import org.u2sa.core.communication.limit.PendingConnections;
import org.u2sa.core.communication.limit.TimeShare;
import org.u2sa.core.communication.limit.WorkQueue;
import org.u2sa.core.communication.routing.RemoteSubscriptions;
import org.u2sa.core.communication.routing.RetainedTable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;

/** State shared by the sessions of all clients: limits, users, subscriptions, retained messages. */
final class BrokerState implements AutoCloseable {
  static final String TOO_SLOW = "client disconnected: it is too slow";

  /** Part of the network thread's time for reading clients without a log-in, and for sending. */
  private static final double ANONYMOUS_PART = 0.1;

  private static final double PIECE_S = 0.005; // such a slice may delay an emergency stop
  private static final double TOTAL_BURST_S = 0.01; // maximum delay a flood may cause

  final BrokerLimits limits;
  final MessageCodec codec;
  private final Clock clock;
  final Refusals refusals;
  private final Users users; // null grants everyone full access
  final Authenticator authenticator; // null likewise
  private final byte[] pass = newPass();
  private final AtomicLong kept = new AtomicLong();
  final PendingConnections<Client> pending = new PendingConnections<>(); // of the MQTT port
  final PendingConnections<Client> webPending = pending.ofAnotherPort();
  private final AtomicLong dropped = new AtomicLong();
  final ClientTable clients;
  final RetainedTable retained;
  final Allowance.PerUser questions; // queries sent to all services
  final MemoryBudget<Client> unfinished = // packets; touched by the network's thread only
      MemoryBudget.ofClients(
          8, 64 << 20, "connection closed, too many bytes waiting for the rest of a packet");
  final MemoryBudget<Client> unsent = // or unacknowledged; touched by the network's thread only
      MemoryBudget.ofClients(4, 256 << 20, TOO_SLOW);
  final Allowance beyondShares; // of all clients; confined to the network thread
  final CostlyTime costlyTime; // of all clients; confined to the network thread
  final WorkQueue webTurns; // of clients that have not logged in; confined to the network thread
  final TimeShare anonymousInput; // of clients without a log-in; confined to the network thread
  final AnonymousOutput anonymousOutput; // likewise
  final RemoteSubscriptions subscriptions = new RemoteSubscriptions();
  final MessageRouter router;
  final SourceNames sources;
  private volatile boolean ending;

  /**
   * @param users the known users; null lets anyone connect without a password
   */
  BrokerState(
      BrokerLimits limits, MessageCodec codec, Clock clock, Users users, Consumer<String> log) {
    this.limits = limits;
    this.codec = codec;
    this.clock = clock;
    this.users = users;
    refusals = new Refusals(log);
    authenticator =
        users == null || !users.havePasswords()
            ? null
            : new Authenticator(users, clock, what -> refusals.add("log-in failed", what));
    clients = new ClientTable(limits, users != null);
    retained = new RetainedTable(limits);
    router = new MessageRouter(subscriptions, retained, clients);
    sources = new SourceNames(codec);
    questions = new Allowance.PerUser(limits.clientQuestionsPerSecond());
    double totalPerS = limits.totalMessagesPerSecond();
    beyondShares = new Allowance(totalPerS, TOTAL_BURST_S * totalPerS, clock.micros());
    costlyTime = new CostlyTime(clock.micros());
    webTurns = new WorkQueue(clock::micros);
    anonymousInput = new TimeShare(ANONYMOUS_PART, PIECE_S, clock::micros);
    anonymousOutput =
        new AnonymousOutput(new TimeShare(ANONYMOUS_PART, PIECE_S, clock::micros), this::dropped);
  }

  private static byte[] newPass() {
    byte[] random = new byte[32];
    new SecureRandom().nextBytes(random);
    return Base64.getEncoder().encode(random);
  }

  /** Secret that replaces the password of admitted connections. */
  String pass() {
    return new String(pass, StandardCharsets.US_ASCII);
  }

  boolean isPass(byte[] password) {
    return password != null && MessageDigest.isEqual(pass, password);
  }

  void leave(String clientId, Client client) {
    clients.leave(clientId, client);
    subscriptions.remove(client.connection());
  }

  long nowMicros() {
    return clock.micros();
  }

  /** The known users; empty if anyone may connect without a password. */
  Optional<Users> users() {
    return Optional.ofNullable(users);
  }

  /** Counts a message that is kept until all its subscribers have acknowledged it. */
  void keep(int bytes) {
    kept.addAndGet(bytes);
  }

  long kept() {
    return kept.get();
  }

  /** Counts a message dropped because a client was too slow. */
  void dropped(String client) {
    dropped.incrementAndGet();
    refusals.add("message to a slow client dropped", client);
  }

  long dropped() {
    return dropped.get();
  }

  /** Whether the broker is shutting down and accepts nothing new. */
  boolean isEnding() {
    return ending;
  }

  void end() {
    ending = true;
  }

  @Override
  public void close() {
    if (authenticator != null) {
      authenticator.close();
    }
  }
}
