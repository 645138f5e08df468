package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.messages.schema.U2SAData;

/**
 * The direct path of the Communication Manager: services of its own process are handed messages
 * object to object, on the publisher's thread, without socket or encoding.
 *
 * <p>Any number of {@link Bridge bridges} may be attached and detached while messages flow: for
 * remote subscribers, recorders and observers.
 */
public final class LocalBus implements Transport {
  private final String systemId;
  private final Map<String, Route> routes = new ConcurrentHashMap<>();
  private final Set<String> names = ConcurrentHashMap.newKeySet();
  private final AtomicLong connections = new AtomicLong();
  private final List<Bridge> bridges = new CopyOnWriteArrayList<>();

  /** A bus for the services of one system. */
  public LocalBus(String systemId) {
    this.systemId = Topic.checkSystemId(systemId);
  }

  /**
   * Receives each message that a local service publishes, on the publisher's thread; must not
   * block. Exceptions are counted and reported to the publisher.
   */
  @FunctionalInterface
  public interface Bridge {
    /** Takes one frozen message that a local service published. */
    void forward(Channel<?> channel, U2SAData message);

    /**
     * Takes a retained message that came from another process where a local service publishes too,
     * and that is the last one on the bus now. A bridge behind which the last one is kept as well
     * forwards it, as a copy of an older message may have got there after it.
     */
    default void restate(Channel<?> channel, U2SAData message) {
      // observers of what services publish do not need it
    }
  }

  /**
   * Attaches a bridge, besides those that are there. It is given what is retained at once, since
   * the broker behind it may be new and know nothing; what is published meanwhile may come to it
   * twice, but never an older message after a newer one.
   */
  public void attach(Bridge added) {
    bridges.add(added);
    routes.values().forEach(route -> route.handRetained(added));
  }

  /** Detaches a bridge. A message on its way on another thread may still reach it. */
  public void detach(Bridge removed) {
    bridges.removeIf(bridge -> bridge == removed);
  }

  /** Delivers a frozen message that came from another process to the local subscribers. */
  public void deliver(Channel<?> channel, U2SAData message) {
    route(channel).deliver(channel, message, null);
  }

  /** Whether any service of this process is subscribed to the channel of that name. */
  public boolean isHeard(String channelName) {
    Route route = routes.get(channelName);
    return route != null && route.subscriptions.length > 0;
  }

  /** Counts messages of other processes that were lost on their way to the bus. */
  public void missed(Channel<?> channel, long messages) {
    for (Subscription subscription : route(channel).subscriptions) {
      subscription.owner.missed.addAndGet(messages);
    }
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    if (!names.add(serviceName)) {
      throw new CommunicationException(
          String.format(
              "service name \"%s\" is taken in system \"%s\": names must differ",
              serviceName, systemId));
    }
    return new LocalConnection(serviceName, receiver);
  }

  @Override
  public String systemId() {
    return systemId;
  }

  private Route route(Channel<?> channel) {
    Route route =
        routes.get(channel.name()); // computeIfAbsent takes a lock even if the key is there
    return route != null ? route : routes.computeIfAbsent(channel.name(), name -> new Route());
  }

  /** One of a bridge's methods. */
  @FunctionalInterface
  private interface Crossing {
    void cross(Bridge bridge, Channel<?> channel, U2SAData message);
  }

  private record Subscription(LocalConnection owner, Channel<?> channel, Receiver receiver) {
    /**
     * Hands on what the subscriber's channel carries.
     *
     * @param carrier a channel that is known to carry the message; null if none is
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

  /** The subscribers of one channel, and what is retained on it. */
  private static final class Route {
    private static final int MAX_RETAINED = 1_000; // sources, which others may invent

    /**
     * Copied when one is added or removed, under this; as an array, since each message goes over
     * it.
     */
    private volatile Subscription[] subscriptions = {};

    private final Map<String, U2SAData> retained = new LinkedHashMap<>();
    private final Map<String, LocalConnection> publishers = new HashMap<>(); // last ones, by source
    private Channel<?> channel; // of what is retained

    /**
     * Hands a message to all subscribers, then to the bridges.
     *
     * @param publisher whose bridges it crosses; null if it came from another process
     */
    void deliver(Channel<?> on, U2SAData message, LocalConnection publisher) {
      Channel<?> carrier = publisher == null ? null : on; // publishing checks it
      if (on.isRetained()) {
        // So that a new subscriber sees a retained message once, and that of two publishers the
        // same one comes last here and beyond the bridges.
        synchronized (this) {
          channel = on;
          String source = on.sourceOf(message);
          if (retained.size() < MAX_RETAINED || retained.containsKey(source)) {
            retained.put(source, message);
          }
          hand(message, carrier);
          if (publisher != null) {
            publishers.put(source, publisher);
            publisher.cross(on, message, Bridge::forward);
          } else if (publishers.containsKey(source)) {
            publishers.get(source).cross(on, message, Bridge::restate);
          }
        }
      } else {
        hand(message, carrier);
        if (publisher != null) {
          publisher.cross(on, message, Bridge::forward);
        }
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

    /**
     * Counts and reports that a receiver or a bridge threw; the publisher and other receivers go on
     * unaffected.
     */
    void failed(String what, Channel<?> channel, RuntimeException error) {
      long count = refused.incrementAndGet();
      if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
        try {
          receiver.trouble(
              what + " on \"" + channel + "\" failed: " + error + " (" + count + " so far)");
        } catch (RuntimeException e) {
          return; // it cannot be told either; the count is there, and its owner's health shows it
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
