package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.messages.schema.U2SAData;

/**
 * The Communication Manager's in-process path: messages are passed as objects on the publisher's
 * thread, without sockets or encoding.
 *
 * <p>Any number of {@link Bridge bridges} may be attached and detached at run time: for remote
 * subscribers, recorders and observers.
 */
public final class LocalBus implements Transport {
  /**
   * Memory limit of a channel's retained messages from other processes, if it has several sources.
   */
  private static final long MAX_RETAINED_BYTES =
      Math.max(2L << 20, Runtime.getRuntime().maxMemory() / 64);

  private final String systemId;
  private final long maxRetainedBytes;
  private final Map<String, Route> routes = new ConcurrentHashMap<>();
  private final Set<String> names = ConcurrentHashMap.newKeySet();
  private final AtomicLong connections = new AtomicLong();
  private final List<Bridge> bridges = new CopyOnWriteArrayList<>();

  public LocalBus(String systemId) {
    this(systemId, MAX_RETAINED_BYTES);
  }

  LocalBus(String systemId, long maxRetainedBytes) {
    this.maxRetainedBytes = maxRetainedBytes;
    this.systemId = Topic.checkSystemId(systemId);
  }

  /**
   * Receives each message published by a local service, on the publisher's thread; must not block.
   * Exceptions are counted and reported to the publisher.
   */
  @FunctionalInterface
  public interface Bridge {
    void forward(Channel<?> channel, U2SAData message);

    /**
     * Handles a retained message from another process that is now the last one on a topic that a
     * local service also publishes. A bridge with its own retained store forwards it, because a
     * copy of an older message may have arrived there later.
     */
    default void restate(Channel<?> channel, U2SAData message) {
      // not needed by observers of published messages
    }
  }

  /**
   * Attaches a bridge, which immediately receives the retained messages. Messages published during
   * the swap may arrive twice, but never out of order.
   */
  public void attach(Bridge added) {
    bridges.add(added);
    routes.values().forEach(route -> route.handRetained(added));
  }

  /** Detaches a bridge. A message in flight on another thread may still reach it. */
  public void detach(Bridge removed) {
    bridges.removeIf(bridge -> bridge == removed);
  }

  /** Delivers a frozen message from another process to local subscribers. */
  public void deliver(Channel<?> channel, U2SAData message) {
    route(channel).deliver(channel, message, null);
  }

  /** Whether any local service subscribes to a channel. */
  public boolean isHeard(String channelName) {
    Route route = routes.get(channelName);
    return route != null && route.subscriptions.length > 0;
  }

  /** Whether a connected local service was the latest to publish for this source of a channel. */
  public boolean isLocal(String channelName, String source) {
    Route route = routes.get(channelName);
    LocalConnection publisher = route == null ? null : route.publishers.get(source);
    return publisher != null && !publisher.closed;
  }

  /** Whether a connected local service has published on a channel. */
  public boolean isPublished(String channelName) {
    Route route = routes.get(channelName);
    return route != null
        && route.publishers.values().stream().anyMatch(publisher -> !publisher.closed);
  }

  /** Counts messages from other processes lost on the way here, at most {@link Long#MAX_VALUE}. */
  public void missed(Channel<?> channel, long messages) {
    for (Subscription subscription : route(channel).subscriptions) {
      subscription.owner.missed.updateAndGet(
          count -> messages > Long.MAX_VALUE - count ? Long.MAX_VALUE : count + messages);
    }
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    if (!names.add(serviceName)) {
      throw new NameTakenException(
          serviceName,
          String.format(
              "service name \"%s\" is taken in system \"%s\": service names must be unique",
              serviceName, systemId));
    }
    return new LocalConnection(serviceName, receiver);
  }

  @Override
  public String systemId() {
    return systemId;
  }

  private Route route(Channel<?> channel) {
    Route route = routes.get(channel.name()); // computeIfAbsent locks even for existing keys
    return route != null ? route : routes.computeIfAbsent(channel.name(), name -> new Route());
  }

  @FunctionalInterface
  private interface Crossing {
    void cross(Bridge bridge, Channel<?> channel, U2SAData message);
  }

  private record Subscription(LocalConnection owner, Channel<?> channel, Receiver receiver) {
    /**
     * @param carrier a channel known to carry the message; null if unknown
     */
    void hand(U2SAData message, Channel<?> carrier) {
      if (channel == carrier || channel.carries(message)) {
        try {
          receiver.receive(channel, message);
        } catch (RuntimeException e) {
          owner.failed("receiving", channel, e);
        }
      }
    }
  }

  /** Subscribers and retained messages of a channel. */
  private final class Route {
    private static final int MAX_RETAINED = 1_000; // sources, which others may invent

    /** Copy-on-write under this; an array because every message iterates over it. */
    private volatile Subscription[] subscriptions = {};

    private final Map<String, U2SAData> retained = new LinkedHashMap<>();
    private long retainedBytes; // of other processes' messages
    private final Map<String, LocalConnection> publishers =
        new ConcurrentHashMap<>(); // latest publishers, by source
    private Channel<?> channel; // channel of the retained messages

    /**
     * Delivers a message to all subscribers, then to the bridges.
     *
     * @param publisher null for messages from another process
     */
    void deliver(Channel<?> on, U2SAData message, LocalConnection publisher) {
      Channel<?> carrier = publisher == null ? null : on; // checked on publishing
      if (on.isRetained()) {
        // Ensures that a new subscriber sees a retained message once, and that the last of two
        // publishers' messages is the same here and beyond the bridges.
        synchronized (this) {
          channel = on;
          String source = on.sourceOf(message);
          retain(source, message, publisher != null);
          hand(message, carrier);
          if (publisher != null) {
            remember(source, publisher);
            publisher.cross(on, message, Bridge::forward);
          } else if (publishers.containsKey(source)) {
            publishers.get(source).cross(on, message, Bridge::restate);
          }
        }
      } else {
        hand(message, carrier);
        if (publisher != null) {
          remember(on.sourceOf(message), publisher);
          publisher.cross(on, message, Bridge::forward);
        }
      }
    }

    private void remember(String source, LocalConnection publisher) {
      if (publishers.get(source) != publisher) { // a read is cheaper
        publishers.put(source, publisher);
      }
    }

    /**
     * Retains a message if there is room; otherwise drops it and the outdated message that it
     * replaces. A message of a channel with one source, such as an emergency stop, always has room.
     */
    private void retain(String source, U2SAData message, boolean isOwn) {
      U2SAData before = retained.get(source);
      long bytes =
          retainedBytes + message.receivedBytes() - (before == null ? 0 : before.receivedBytes());
      boolean isNew = before == null && retained.size() >= MAX_RETAINED;
      if (isOwn || source.isEmpty() || !isNew && bytes <= maxRetainedBytes) {
        retained.put(source, message);
        retainedBytes = bytes;
      } else if (before != null) {
        retained.remove(source);
        retainedBytes -= before.receivedBytes();
      }
    }

    private void hand(U2SAData message, Channel<?> carrier) {
      for (Subscription subscription : subscriptions) {
        subscription.hand(message, carrier);
      }
    }

    synchronized void handRetained(Bridge added) {
      retained.values().forEach(message -> added.forward(channel, message));
    }

    synchronized void add(Subscription added) {
      remove(added.owner);
      Subscription[] more = Arrays.copyOf(subscriptions, subscriptions.length + 1);
      more[subscriptions.length] = added;
      subscriptions = more;
      for (U2SAData message : retained.values()) {
        added.hand(message, null);
      }
    }

    synchronized void remove(LocalConnection owner) {
      subscriptions =
          Arrays.stream(subscriptions)
              .filter(subscription -> subscription.owner != owner)
              .toArray(Subscription[]::new);
    }
  }

  private final class LocalConnection implements Connection {
    private final String serviceName;
    private final Receiver receiver;
    private final String instance = "local-" + connections.incrementAndGet();
    private final AtomicLong refused = new AtomicLong();
    private final AtomicLong missed = new AtomicLong();
    private volatile boolean closed; // written under this

    LocalConnection(String serviceName, Receiver receiver) {
      this.serviceName = serviceName;
      this.receiver = receiver;
    }

    @Override
    public String instance() {
      return instance;
    }

    @Override
    public boolean publish(Channel<?> channel, U2SAData message) {
      if (closed || !channel.carries(message)) {
        refused.incrementAndGet();
        return false;
      }
      route(channel).deliver(channel, message, this);
      return true;
    }

    void cross(Channel<?> channel, U2SAData message, Crossing how) {
      for (Bridge bridge : bridges) {
        try {
          how.cross(bridge, channel, message);
        } catch (RuntimeException e) {
          failed("forwarding", channel, e);
        }
      }
    }

    /** Counts and reports an exception of a receiver or bridge, without affecting the others. */
    void failed(String what, Channel<?> channel, RuntimeException error) {
      long count = refused.incrementAndGet();
      if (Long.bitCount(count) == 1) { // log at 1, 2, 4, 8…, to avoid a flood
        try {
          receiver.trouble(
              what + " on \"" + channel + "\" failed: " + error + " (" + count + " so far)");
        } catch (RuntimeException e) {
          return; // reporting failed too; the count remains visible in its owner's health
        }
      }
    }

    @Override
    public synchronized boolean subscribe(Channel<?> channel) {
      if (closed) {
        return false;
      }
      route(channel).add(new Subscription(this, channel, receiver));
      return true;
    }

    @Override
    public boolean unsubscribe(Channel<?> channel) {
      route(channel).remove(this);
      return !closed;
    }

    @Override
    public long missed() {
      return missed.get();
    }

    @Override
    public long refused() {
      return refused.get();
    }

    @Override
    public synchronized void close() {
      if (!closed) {
        closed = true;
        routes.values().forEach(route -> route.remove(this));
        names.remove(serviceName);
      }
    }
  }
}
