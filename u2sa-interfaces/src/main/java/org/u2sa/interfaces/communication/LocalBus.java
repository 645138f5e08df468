package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.messages.U2SAData;

/**
 * The direct path of the Communication Manager: services of its own process are handed messages
 * object to object, on the publisher's thread, without socket or encoding.
 *
 * <p>A {@link Bridge} may be attached to give remote subscribers their copies.
 */
public final class LocalBus implements Transport {
  private final String systemId;
  private final Map<String, Route> routes = new ConcurrentHashMap<>();
  private final Set<String> names = ConcurrentHashMap.newKeySet();
  private final AtomicLong connections = new AtomicLong();
  private volatile Bridge bridge = (channel, message) -> {};

  /** A bus for the services of one system. */
  public LocalBus(String systemId) {
    this.systemId = Topic.checkSystemId(systemId);
  }

  /** What carries copies of local messages to other processes. Must not block. */
  @FunctionalInterface
  public interface Bridge {
    /** Takes one frozen message that a local service published. */
    void forward(Channel<?> channel, U2SAData message);
  }

  /**
   * Attaches the bridge to other processes, in place of the one before. It is given what is
   * retained at once, since the broker behind it may be new and know nothing.
   */
  public void attach(Bridge newBridge) {
    bridge = newBridge;
    routes.values().forEach(route -> route.handRetained(newBridge));
  }

  /** Takes the bridge off: nothing leaves this process until another one is attached. */
  public void detach() {
    bridge = (channel, message) -> {};
  }

  /** Delivers a frozen message that came from another process to the local subscribers. */
  public void deliver(Channel<?> channel, U2SAData message) {
    route(channel).deliver(channel, message);
  }

  /** Takes note that messages of other processes were lost on their way to the bus. */
  public void missed(Channel<?> channel, long messages) {
    for (Subscription subscription : route(channel).subscriptions) {
      subscription.owner.missed.addAndGet(messages);
    }
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    if (!names.add(serviceName)) {
      throw new CommunicationException(
          "service name \""
              + serviceName
              + "\" is taken in system \""
              + systemId
              + "\": names must differ");
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

  private record Subscription(LocalConnection owner, Channel<?> channel, Receiver receiver) {
    void hand(U2SAData message) {
      if (channel.carries(message)) {
        try {
          receiver.receive(channel, message);
        } catch (RuntimeException e) {
          owner.failed(channel, e);
        }
      }
    }
  }

  /** The subscribers of one channel, and what is retained on it. */
  private static final class Route {
    private volatile Subscription[] subscriptions = {};
    private final Map<String, U2SAData> retained = new LinkedHashMap<>();
    private Channel<?> channel; // of what is retained

    void deliver(Channel<?> on, U2SAData message) {
      if (on.isRetained()) {
        synchronized (this) { // so that a new subscriber sees a retained message once
          channel = on;
          retained.put(on.sourceOf(message), message);
          hand(message);
        }
      } else {
        hand(message);
      }
    }

    private void hand(U2SAData message) {
      for (Subscription subscription : subscriptions) {
        subscription.hand(message);
      }
    }

    synchronized void handRetained(Bridge newBridge) {
      retained.values().forEach(message -> newBridge.forward(channel, message));
    }

    synchronized void add(Subscription added) {
      remove(added.owner);
      Subscription[] longer = new Subscription[subscriptions.length + 1];
      System.arraycopy(subscriptions, 0, longer, 0, subscriptions.length);
      longer[subscriptions.length] = added;
      subscriptions = longer;
      for (U2SAData message : retained.values()) {
        added.hand(message);
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
      deliver(channel, message);
      bridge.forward(channel, message);
      return true;
    }

    /** Counts and tells that the receiver threw: neither publisher nor other receivers notice. */
    void failed(Channel<?> channel, RuntimeException error) {
      long count = refused.incrementAndGet();
      if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
        try {
          receiver.trouble(
              "receiving on \"" + channel + "\" failed: " + error + " (" + count + " so far)");
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
