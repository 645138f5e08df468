package org.u2sa.core.communication;

import java.net.InetSocketAddress;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.interfaces.communication.CommunicationException;

/** Holds the embedded broker of a running system, and puts a new one in its place when it fails. */
final class BrokerKeeper implements AutoCloseable {
  private final Function<Runnable, EmbeddedBroker> starter;
  private final Consumer<String> log;
  private EmbeddedBroker broker; // this and the following under this
  private long droppedBefore; // by predecessors
  private boolean closed;

  /**
   * Starts the broker.
   *
   * @param starter starts one, given whom to tell when it fails
   */
  BrokerKeeper(Function<Runnable, EmbeddedBroker> starter, Consumer<String> log) {
    this.starter = starter;
    this.log = log;
    broker = starter.apply(this::failed);
  }

  /** Called on a thread of the broker, which is not to end itself. */
  private void failed() {
    Thread repair =
        new Thread(
            () -> {
              try {
                restart();
              } catch (CommunicationException e) {
                log.accept(e.getMessage() + "; services of other processes are cut off");
              }
            },
            "u2sa-broker-restart");
    repair.setDaemon(true);
    repair.start();
  }

  /**
   * Puts a new broker in the place of the one that runs.
   *
   * @throws CommunicationException if it cannot listen
   */
  synchronized void restart() {
    if (closed) {
      return;
    }
    broker.close();
    droppedBefore += broker.dropped();
    broker = starter.apply(this::failed);
    log.accept("the broker was started anew at " + broker.address());
  }

  synchronized InetSocketAddress address() {
    return broker.address();
  }

  /** The broker that runs. */
  synchronized EmbeddedBroker broker() {
    return broker;
  }

  synchronized long dropped() {
    return droppedBefore + broker.dropped();
  }

  @Override
  public synchronized void close() {
    if (!closed) {
      closed = true;
      broker.close();
    }
  }
}
