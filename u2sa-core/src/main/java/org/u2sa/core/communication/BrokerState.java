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
import org.u2sa.core.communication.routing.RemoteSubscriptions;
import org.u2sa.core.communication.routing.RetainedTable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;

/** What the sessions of all clients share: limits, users, subscriptions, retained messages. */
final class BrokerState implements AutoCloseable {
  static final String TOO_SLOW = "client disconnected, it is too slow";

  private static final double TOTAL_BURST_S = 0.01; // how long a flood may delay other clients

  private final BrokerLimits limits;
  private final MessageCodec codec;
  private final Clock clock;
  private final Refusals refusals;
  private final Users users; // null grants everyone full access
  private final Authenticator authenticator; // null likewise
  private final byte[] pass = newPass();
  private final AtomicLong kept = new AtomicLong();
  private final PendingConnections<Client> pending = new PendingConnections<>();
  private final AtomicLong dropped = new AtomicLong();
  private final ClientTable clients;
  private final RetainedTable retained;
  private final Allowance.PerUser questions;
  private final MemoryBudget<Client> unfinished = // touched by the network's thread only
      MemoryBudget.ofClients(
          8, 64 << 20, "connection closed, too many bytes wait for the rest of a packet");
  private final MemoryBudget<Client> unsent = // touched by the network's thread only
      MemoryBudget.ofClients(4, 256 << 20, TOO_SLOW);
  private final Allowance beyondShares; // touched by the network's thread only
  private final CostlyTime costlyTime; // touched by the network's thread only
  private final RemoteSubscriptions subscriptions = new RemoteSubscriptions();
  private final MessageRouter router;
  private final SourceNames sources;
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

  /** Whether it is that pass. */
  boolean isPass(byte[] password) {
    return password != null && MessageDigest.isEqual(pass, password);
  }

  /** The admitted clients. */
  ClientTable clients() {
    return clients;
  }

  /** Forgets a client that has left. */
  void leave(String clientId, Client client) {
    clients.leave(clientId, client);
    subscriptions.remove(client.connection());
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

  /** Who may publish under which source name. */
  SourceNames sources() {
    return sources;
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
  MemoryBudget<Client> unfinished() {
    return unfinished;
  }

  /**
   * Memory budget for messages that clients have not read or acknowledged. For the network's
   * thread.
   */
  MemoryBudget<Client> unsent() {
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

  PendingConnections<Client> pending() {
    return pending;
  }

  /** Counts a message dropped because a client was too slow. */
  void dropped(String client) {
    dropped.incrementAndGet();
    refusals.add("message to a slow client dropped", client);
  }

  /** Number of messages dropped because a client was too slow. */
  long dropped() {
    return dropped.get();
  }

  /** Whether the broker is shutting down and accepts nothing new. */
  boolean isEnding() {
    return ending;
  }

  /** Accepts nothing new from now on. */
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
