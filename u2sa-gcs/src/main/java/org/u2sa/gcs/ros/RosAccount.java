package org.u2sa.gcs.ros;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.core.communication.bridge.ClientBridge;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.AccessTable;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageType;

/**
 * The broker user that a bridge client acts as, with its own connection, so that the broker checks
 * everything the client sends. Thread-safe.
 */
final class RosAccount {
  private static final double ANSWER_WITHIN_S = 3.0;
  private static final String BASIC = "Basic ";

  private final ClientBridge.Setting setting;
  private final String clientName;
  private final Consumer<String> trouble;
  private String user = ""; // guarded by this
  private char[] password = new char[0]; // guarded by this
  private RemoteLink link; // null until needed; guarded by this
  private volatile boolean operates;

  /**
   * @param clientName name of the connection in the broker's log
   * @param trouble receives a line when the connection is lost or restored
   */
  RosAccount(ClientBridge.Setting setting, String clientName, Consumer<String> trouble) {
    this.setting = setting;
    this.clientName = clientName;
    this.trouble = trouble;
  }

  /**
   * Takes user and password from an HTTP header (RFC 7617), which programs can set.
   *
   * @throws BadInputException if malformed
   */
  void authorization(String header) {
    try {
      String text =
          new String(
              Base64.getDecoder().decode(header.substring(BASIC.length())), StandardCharsets.UTF_8);
      int colon = text.indexOf(':');
      if (header.startsWith(BASIC) && colon > 0) {
        as(text.substring(0, colon), text.substring(colon + 1));
        return;
      }
    } catch (IllegalArgumentException | StringIndexOutOfBoundsException e) {
      throw new BadInputException("header Authorization: expected Basic and base64", e);
    }
    throw new BadInputException("header Authorization: expected Basic with USER:PASSWORD");
  }

  /**
   * Sets user and password before the first use.
   *
   * @throws BadInputException if already in use
   */
  synchronized void as(String name, String secret) {
    if (link != null) {
      throw new BadInputException(
          "auth: this connection already acts as "
              + (user.isEmpty() ? "an anonymous user" : "\"" + user + "\"")
              + "; log in first, or on a new connection");
    }
    user = name;
    password = secret.toCharArray();
  }

  /**
   * The connection, created on first use.
   *
   * @throws org.u2sa.interfaces.communication.CommunicationException if the broker refuses the user
   */
  synchronized RemoteLink link() {
    if (link == null) {
      link =
          new RemoteLink(
              setting.broker().as(user, password),
              clientName,
              new SystemClock(),
              ANSWER_WITHIN_S,
              trouble);
      link.keepTime();
      operates = setting.operators().test(user);
    }
    return link;
  }

  /** Whether the broker has accepted its user as an operator. */
  boolean operates() {
    return operates;
  }

  /**
   * Requires that users may publish the type on the channel, and that this user may: the broker
   * drops unauthorised messages silently.
   *
   * @throws BadInputException stating what is required
   */
  synchronized void requireRight(Channel<?> channel, MessageType<?> type) {
    Optional<AccessRule> rule = AccessTable.rule(channel.name(), type);
    boolean isOrder =
        rule.isPresent()
            && rule.get().roles().contains(AccessRole.OPERATOR)
            && (rule.get().kind() != AccessRule.Kind.REPORT
                || channel.equals(Channels.GOAL_UPDATES)
                || channel.equals(Channels.OPERATOR)
                || channel.equals(Channels.MANUAL_DRIVE));
    if (!isOrder) {
      throw new BadInputException(
          "a "
              + type.name()
              + " on "
              + channel
              + " is published by the vehicle only; ROS tools may send what an operator may");
    }
    if (rule.get().kind() != AccessRule.Kind.QUESTION && !setting.operators().test(user)) {
      throw new BadInputException(
          (user.isEmpty() ? "without a log-in" : "user \"" + user + "\"")
              + " this connection only listens; orders need the role operator"
              + " (docs/ros.md#log-in)");
    }
  }

  synchronized void close() {
    if (link != null) {
      link.close();
    }
  }
}
