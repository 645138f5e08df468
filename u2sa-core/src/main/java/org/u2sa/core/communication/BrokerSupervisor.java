package org.u2sa.core.communication;

import java.net.InetSocketAddress;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.interfaces.communication.CommunicationException;

/** Owns the embedded broker of a running system, and replaces it when it fails. */
final class BrokerSupervisor implements AutoCloseable {
  private static final long TRY_AGAIN_MS = 500;

  private final Function<Runnable, EmbeddedBroker> starter;
  private final Consumer<String> log;
  private final InetSocketAddress address;
  private volatile EmbeddedBroker broker; // null if none could be started; changed under this
  private long droppedBefore; // by predecessors; guarded by this, as below
  private boolean closed;

  /** Starts the broker; {@code starter} is given a callback for the broker's failure. */
  BrokerSupervisor(Function<Runnable, EmbeddedBroker> starter, Consumer<String> log) {
    this.starter = starter;
    this.log = log;
    broker = started();
    address = broker.address();
  }

  private EmbeddedBroker started() {
    AtomicBoolean told = new AtomicBoolean();
    return starter.apply(
        () -> {
          if (told.compareAndSet(false, true)) { // several broker threads may fail
            repairSoon();
          }
        });
  }

  /** Called on a broker thread, which must not shut down itself; repairs on another thread. */
  private void repairSoon() {
    Thread repair = new Thread(this::repair, "u2sa-broker-restart");
    repair.setDaemon(true);
    repair.start();
  }

  private synchronized void repair() {
    String lastFailure = "";
    while (!closed) {
      try {
        restart();
        return;
      } catch (RuntimeException e) { // port taken, or any other failure
        String failure = e instanceof CommunicationException ? e.getMessage() : e.toString();
        if (!lastFailure.equals(failure)) {
          lastFailure = failure; // logged once, however long it lasts
          log.accept(failure + "; services of other processes are cut off, retrying");
        }
      }
      try {
        wait(TRY_AGAIN_MS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  /**
   * Replaces the running broker with a new one.
   *
   * @throws CommunicationException if it cannot listen
   */
  synchronized void restart() {
    if (closed) {
      return;
    }
    endPresent();
    broker = started();
    log.accept("broker restarted at " + address);
  }

  private void endPresent() {
    EmbeddedBroker present = broker;
    if (present != null) {
      broker = null; // even if closing it fails
      present.close();
      droppedBefore += present.dropped();
    }
  }

  InetSocketAddress address() {
    return address;
  }

  /**
   * As {@link EmbeddedBroker#isOfVehicle}; false while there is no broker. Never blocks: a closing
   * broker waits for its network thread, which may call this.
   */
  boolean isOfVehicle(String serviceName) {
    EmbeddedBroker present = broker;
    return present != null && present.isOfVehicle(serviceName);
  }

  /** Number of messages dropped because clients or the broker were too slow, since the start. */
  synchronized long dropped() {
    return droppedBefore + (broker == null ? 0 : broker.dropped());
  }

  @Override
  public synchronized void close() {
    closed = true;
    endPresent();
    notifyAll();
  }
}
