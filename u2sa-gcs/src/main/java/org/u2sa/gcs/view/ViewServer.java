package org.u2sa.gcs.view;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.gcs.socket.ClientSocket;
import org.u2sa.gcs.socket.WebSocketServer;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.report.message.JsonReader;

/**
 * Serves channels to viewers through the Foxglove WebSocket protocol, version 1: server info,
 * advertisements, status, messages. Reads subscriptions, and answers everything else with an error.
 */
public final class ViewServer implements AutoCloseable {
  private static final String SUBPROTOCOLS = "foxglove.sdk.v1,foxglove.websocket.v1";
  private static final int MAX_VIEWERS = 32;
  private static final int MAX_CHANNELS = 2048; // of a running system
  private static final int MAX_VALUES = 16_384; // in a request; each subscription needs 3

  private final String name;
  private final boolean tellsTime;
  private final String sessionId;
  private final Consumer<String> remarks;
  private final ViewChannels channels = new ViewChannels();
  private final Set<ViewerSession> viewers = ConcurrentHashMap.newKeySet();
  private volatile boolean saidFull;
  private long notShown; // messages; of the feed's thread
  private final WebSocketServer server;

  /**
   * Starts listening.
   *
   * @param name name of the source
   * @param sessionId a new ID makes viewers discard their data
   * @param tellsTime whether viewers use {@link #time} as their clock, as for a recording
   * @param origins additional web pages that may connect, such as https://viewer.example
   * @param remarks receives connects and disconnects
   * @throws org.u2sa.interfaces.RunFailedException if the port is taken
   */
  public ViewServer(
      InetSocketAddress address,
      String name,
      String sessionId,
      boolean tellsTime,
      Set<String> origins,
      Consumer<String> remarks) {
    this.name = name;
    this.sessionId = sessionId;
    this.tellsTime = tellsTime;
    this.remarks = remarks;
    server =
        new WebSocketServer(
            new WebSocketServer.Offer(
                address, SUBPROTOCOLS, Set.copyOf(origins), MAX_VIEWERS, Optional.empty()),
            this::begin,
            what -> remarks.accept("viewer " + what));
  }

  /** Address on which it listens. */
  public InetSocketAddress address() {
    return server.address();
  }

  int viewers() {
    return viewers.size();
  }

  boolean isWatched() {
    return viewers.stream().anyMatch(ViewerSession::hearsAnything);
  }

  /**
   * Whether the topic has a channel or may get one. Limited, because a running system may produce
   * endless source names.
   */
  boolean hasRoomFor(String topic) {
    if (channels.of(topic).isPresent() || channels.size() < MAX_CHANNELS) {
      return true;
    }
    if (!saidFull) {
      saidFull = true;
      remarks.accept("more than " + MAX_CHANNELS + " topics: further ones are not shown");
    }
    return false;
  }

  /** Reports messages that cannot be shown, ever less often: senders determine the rate. */
  void notShown(String topic, RuntimeException why) {
    if (Long.bitCount(++notShown) == 1) { // 1, 2, 4, 8…
      remarks.accept("a message on " + topic + " cannot be shown, " + notShown + " so far: " + why);
    }
  }

  /** The channel of a topic; created and announced to all if new. */
  ViewChannel channel(
      String topic, String encoding, String schemaName, Supplier<byte[]> schema, boolean latched) {
    return channels
        .of(topic)
        .orElseGet(
            () -> {
              ViewChannel added = channels.add(topic, encoding, schemaName, schema.get(), latched);
              viewers.forEach(viewer -> viewer.send(advertise(List.of(added))));
              return added;
            });
  }

  /**
   * Sends a message to the subscribers of its channel. Does not block.
   *
   * @param nanos time of receipt [ns]
   * @param data evaluated only if a viewer gets it, now or later
   */
  void publish(ViewChannel channel, long nanos, Supplier<byte[]> data) {
    byte[] bytes = null;
    if (channel.latched()) {
      bytes = data.get();
      channels.keep(channel, nanos, bytes);
    }
    for (ViewerSession viewer : viewers) {
      if (viewer.hears(channel.id())) {
        bytes = bytes == null ? data.get() : bytes;
        viewer.message(channel.id(), nanos, bytes);
      }
    }
  }

  /** Sends the current time to all viewers [ns]. */
  void time(long nanos) {
    viewers.forEach(viewer -> viewer.time(nanos));
  }

  @Override
  public void close() {
    server.close();
  }

  private static JsonText advertise(List<ViewChannel> channels) {
    List<JsonText> all = new ArrayList<>();
    channels.forEach(channel -> all.add(channel.advertisement()));
    return new JsonText().put("op", "advertise").put("channels", all);
  }

  private JsonText serverInfo() {
    return new JsonText()
        .put("op", "serverInfo")
        .put("name", name)
        .put("capabilities", tellsTime ? List.of("time") : List.of())
        .put("supportedEncodings", List.of())
        .put("metadata", new JsonText())
        .put("sessionId", sessionId);
  }

  private WebSocketServer.Conversation begin(ClientSocket socket) {
    ViewerSession viewer = new ViewerSession(socket);
    viewer.send(serverInfo());
    viewers.add(viewer); // before reading the channels, so that none is missed
    List<ViewChannel> known = channels.all();
    if (!known.isEmpty()) {
      viewer.send(advertise(known));
    }
    remarks.accept("viewer " + viewer.address() + " connected (" + socket.subprotocol() + ")");
    return new Conversation(viewer);
  }

  private final class Conversation implements WebSocketServer.Conversation {
    private final ViewerSession viewer;

    Conversation(ViewerSession viewer) {
      this.viewer = viewer;
    }

    @Override
    public void ended() {
      viewers.remove(viewer);
      remarks.accept(
          "viewer "
              + viewer.address()
              + " disconnected; "
              + viewer.sent()
              + " messages sent, "
              + viewer.dropped()
              + " dropped because it read too slowly");
    }

    @Override
    public boolean givesWay() {
      return false; // there is no log-in
    }

    @Override
    public void binary() {
      viewer.status(ViewerSession.Level.ERROR, "read-only: viewers' messages are ignored");
    }

    @Override
    public void text(String text) {
      try {
        take(JsonReader.object("request", text, MAX_VALUES));
      } catch (BadInputException e) {
        viewer.status(ViewerSession.Level.ERROR, e.getMessage());
      }
    }

    private void take(Map<String, Object> request) {
      Object operation = request.get("op");
      if ("subscribe".equals(operation)) {
        list(request, "subscriptions").forEach(this::subscribe);
      } else if ("unsubscribe".equals(operation)) {
        list(request, "subscriptionIds").forEach(this::unsubscribe);
      } else {
        viewer.status(
            ViewerSession.Level.ERROR,
            "read-only: \"" + operation + "\" is not served; expected subscribe or unsubscribe");
      }
    }

    private void subscribe(Object element) {
      if (!(element instanceof Map<?, ?> each)
          || !(each.get("id") instanceof Long id)
          || !(each.get("channelId") instanceof Long channelId)) {
        viewer.status(
            ViewerSession.Level.ERROR, "subscription " + element + ": expected id and channelId");
        return;
      }
      if (!channels.has(channelId)) {
        viewer.status(ViewerSession.Level.WARNING, "no channel " + channelId);
        return;
      }
      String refused = viewer.subscribe(id, channelId.intValue());
      if (refused != null) {
        viewer.status(ViewerSession.Level.WARNING, refused);
        return;
      }
      channels
          .last(channelId.intValue())
          .ifPresent(last -> viewer.message(id, last.nanos(), last.data()));
    }

    private void unsubscribe(Object id) {
      if (!(id instanceof Long known) || !viewer.unsubscribe(known)) {
        viewer.status(ViewerSession.Level.WARNING, "no subscription " + id);
      }
    }

    private List<?> list(Map<String, Object> request, String key) {
      if (request.get(key) instanceof List<?> list) {
        return list;
      }
      throw new BadInputException("request " + request.get("op") + ": expected a list " + key);
    }
  }
}
