package org.u2sa.gcs.socket;

import io.netty.channel.Channel;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.u2sa.gcs.socket.WebSocketServer.Conversation;

/**
 * Places of a server's clients, and as many of connections in their handshake: whoever holds all of
 * them and says nothing keeps nobody else out. For the server's thread only.
 */
final class ClientPlaces {
  private static final int HANDSHAKE_WITHIN_S = 10;

  private final int most;
  private final Map<Channel, Future<?>> handshakes = new LinkedHashMap<>(); // oldest first; limits
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

  /** A time limit that stayed would keep a closed connection in memory, thousands a second. */
  private void endHandshake(Channel channel) {
    Future<?> limit = handshakes.remove(channel);
    if (limit != null) {
      limit.cancel(false);
    }
  }

  /**
   * Whether a client may enter. If all places are taken, one that names a user comes instead of the
   * oldest client that gives way.
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
    oldest.ifPresent(each -> each.close("too many clients: one that names a user comes instead"));
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
