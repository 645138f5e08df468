package org.u2sa.core.communication;

import java.net.InetSocketAddress;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.interfaces.communication.CommunicationException;

/** Holds the embedded broker of a running system, and puts a new one in its place when it fails. */
final class BrokerSupervisor implements AutoCloseable {
  private static final long TRY_AGAIN_MS = 500;

  private final Function<Runnable, EmbeddedBroker> starter;
  private final Consumer<String> log;
  private final InetSocketAddress address;
  private EmbeddedBroker broker; // null while none could be started; this and the following: this
  private long droppedBefore; // by predecessors
  private boolean closed;

  /**
   * Starts the broker.
   *
   * @param starter starts one, given whom to tell when it fails
   * @throws CommunicationException if it cannot listen
   */
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
          if (told.compareAndSet(false, true)) { // several of its threads may fail
            repairSoon();
          }
        });
  }

  /** Called on a thread of the broker, which is not to end itself. */
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
      } catch (RuntimeException e) { // a port that is taken, or anything else
        String failure = e instanceof CommunicationException ? e.getMessage() : e.toString();
        if (!lastFailure.equals(failure)) {
          lastFailure = failure; // said once, however long it lasts
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
   * Puts a new broker in the place of the one that runs.
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
      broker = null; // even if its end fails
      present.close();
      droppedBefore += present.dropped();
    }
  }

  InetSocketAddress address() {
    return address;
  }

  /** What clients and the broker were too slow for, since the start. */
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
