package org.u2sa.service;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.WrittenChange;
import org.u2sa.interfaces.time.Clock;

/**
 * Validates and writes requested changes in sequence, on a thread that exists only while changes
 * are pending. The service applies written changes between two messages.
 *
 * <p>The thread takes turns on the run's clock, so in a simulation time stops until a change is
 * written.
 */
final class ConfigurationWriter {
  private static final int CAPACITY = 32;

  /**
   * A change to write.
   *
   * @param write blocks on the disk; called on the writer's thread
   * @param answer handles the result, on the service's thread
   */
  record Order(Supplier<WrittenChange> write, Consumer<WrittenChange> answer) {}

  private record Done(WrittenChange change, Consumer<WrittenChange> answer) {}

  private final ServiceConfiguration configuration;
  private final ServiceLife life;
  private final Queue<Order> orders = new ArrayDeque<>(); // guarded by this
  private final Queue<Done> done = new ConcurrentLinkedQueue<>();
  private Clock.Waiter turn; // of the writer's thread; null if none; guarded by this
  private boolean closed; // guarded by this

  ConfigurationWriter(ServiceConfiguration configuration, ServiceLife life) {
    this.configuration = configuration;
    this.life = life;
  }

  /** Returns false if the queue is full. */
  synchronized boolean order(Order order) {
    if (closed || orders.size() >= CAPACITY) {
      return false;
    }
    orders.add(order);
    if (turn == null) {
      String name = configuration.name();
      Clock.Waiter waiter = configuration.clock().newWaiter(name + "-configuration");
      turn = waiter;
      Thread thread = new Thread(() -> writeAll(waiter), "u2sa-configuration-" + name);
      thread.setDaemon(true);
      thread.start();
    }
    return true;
  }

  private void writeAll(Clock.Waiter waiter) {
    try {
      waiter.await(configuration.clock().micros()); // for its turn
      for (Order order = next(waiter); order != null; order = next(waiter)) {
        done.add(new Done(order.write().get(), order.answer()));
        life.wake();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      life.die(e); // fatal, as on the service's own thread
    } finally {
      end(waiter);
    }
  }

  private synchronized Order next(Clock.Waiter waiter) {
    Order next = closed ? null : orders.poll();
    if (next == null) {
      end(waiter);
    }
    return next;
  }

  private synchronized void end(Clock.Waiter waiter) {
    if (turn == waiter) {
      turn = null;
      life.wake(); // a swap may wait for that
    }
    waiter.close();
  }

  /** Whether a change is being written or waits to be applied. */
  synchronized boolean isBusy() {
    return turn != null || !done.isEmpty();
  }

  boolean hasWritten() {
    return !done.isEmpty();
  }

  /** Applies the oldest written change. */
  void handOver() {
    Done next = done.remove();
    next.answer().accept(next.change());
  }

  /** Accepts no further changes. */
  synchronized void close() {
    closed = true;
    orders.clear();
    if (turn != null) {
      turn.close();
    }
  }
}
