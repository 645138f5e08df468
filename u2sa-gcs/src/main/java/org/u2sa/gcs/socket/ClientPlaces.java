package org.u2sa.gcs.socket;

import io.netty.channel.Channel;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.u2sa.gcs.socket.WebSocketServer.Conversation;

/**
 * Limits a server's clients and, separately, its connections in their handshake, so that silent
 * connections cannot lock others out. For the server's thread only.
 */
final class ClientPlaces {
  private static final int HANDSHAKE_WITHIN_S = 10;

  private final int most;
  private final Map<Channel, Future<?>> handshakes = new LinkedHashMap<>(); // limits, oldest first
  private final Map<ClientSocket, Conversation> clients = new LinkedHashMap<>(); // oldest first

  ClientPlaces(int most) {
    this.most = most;
  }

  /** Takes a new connection; if there are too many in their handshake, the oldest is closed. */
  void connected(Channel channel) {
    handshakes.put(
        channel,
        channel.eventLoop().schedule(() -> channel.close(), HANDSHAKE_WITHIN_S, TimeUnit.SECONDS));
    channel.closeFuture().addListener(closed -> endHandshake(channel));
    if (handshakes.size() > most) {
      handshakes.keySet().iterator().next().close();
    }
  }

  /** Cancels the time limit, which would keep the closed connection in memory. */
  private void endHandshake(Channel channel) {
    Future<?> limit = handshakes.remove(channel);
    if (limit != null) {
      limit.cancel(false);
    }
  }

  /**
   * Whether a client is admitted. If all places are taken, a client that names a user replaces the
   * oldest one that gives way.
   */
  boolean areOpenTo(ClientSocket client) {
    if (clients.size() < most) {
      return true;
    }
    Optional<ClientSocket> oldest =
        client.header("Authorization").isEmpty()
            ? Optional.empty()
            : clients.entrySet().stream()
                .filter(each -> each.getValue().givesWay())
                .map(Map.Entry::getKey)
                .findFirst();
    oldest.ifPresent(each -> each.close("too many clients; replaced by one that names a user"));
    return oldest.isPresent();
  }

  void enter(Channel channel, ClientSocket client, Conversation conversation) {
    endHandshake(channel);
    clients.put(client, conversation);
  }

  void leave(ClientSocket client) {
    clients.remove(client);
  }
}
