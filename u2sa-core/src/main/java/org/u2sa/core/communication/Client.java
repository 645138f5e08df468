package org.u2sa.core.communication;

import io.netty.handler.codec.mqtt.MqttMessage;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import org.u2sa.core.communication.routing.Publication;

/** A client's session, as the rest of the broker sees it. */
interface Client {
  /**
   * Undelivered messages of one client or all.
   *
   * @param messages number sent without knowing whether they arrived
   * @param sentMicros time of the last one [µs]
   */
  record Owed(int messages, long sentMicros) {}

  /** The user's name. */
  String name();

  /** Whether the user is an operator, for whom connections are reserved. */
  boolean isOperator();

  /** Unique ID of the connection, never reused. */
  String connection();

  /** Whether the client has not identified itself yet. */
  boolean isPending();

  /** Whether the session has ended and its packets are ignored. */
  boolean isOut();

  /** Called when Moquette is ready for the client's packets. May be called on any thread. */
  void connected();

  /**
   * Ends the connection because its client reconnected. Its will is not published, because the
   * client is present. May be called on any thread.
   */
  void replaced();

  /**
   * Ends the connection. May be called on any thread.
   *
   * @param kind reason for the log, identical for all clients with that reason
   */
  void putOutFor(String kind);

  /** Like {@link #putOutFor}, immediately and on the connection's thread. */
  void putOut(String kind, String details);

  /**
   * Sends a message. Called on the connection's thread.
   *
   * @param eachMatters whether the client must acknowledge it
   * @return whether the client's backlog calls for slowing down the publisher
   */
  boolean deliver(Publication publication, boolean eachMatters);

  /** Records whether a subscriber of the client's last message is behind. */
  void subscriberIsBehind(boolean behind);

  /** Acknowledges a message of the client. */
  void acknowledge(int packet);

  /** Handles the client's acknowledgement of a message. */
  void acknowledged(int packet);

  void answer(MqttMessage answer);

  /** Number of unsent or unacknowledged messages to the client; may be called on any thread. */
  Future<Owed> owed();

  /**
   * Runs an action on a connection's thread, or drops it if the broker has ended that thread,
   * because its connections are then closed.
   */
  static void execute(Executor connectionThread, Runnable action) {
    try {
      connectionThread.execute(action);
    } catch (RejectedExecutionException e) {
      return;
    }
  }
}
