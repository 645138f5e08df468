package org.u2sa.service;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Hook into everything that passes between a service's code and its environment, in order: clock
 * readings, waits, messages in and out. Recording it allows the service to be re-executed; it then
 * publishes the same messages if it depends on nothing else. By default each method changes
 * nothing, as for a service that is neither recorded nor replayed.
 *
 * <p>Called on the service's thread, and before its start on the thread that creates it; only what
 * {@link #clock} and {@link #outlet} return may be used on other threads.
 */
public interface Execution {
  /** That of a service that is neither recorded nor replayed. */
  Execution NONE = new Execution() {};

  /**
   * Called before a service is created and opens any resource.
   *
   * @throws org.u2sa.interfaces.BadInputException if a service of this role must not be created
   *     here
   */
  default void requireRole(ServiceRole role) {}

  /**
   * The run's clock as seen by the service.
   *
   * @param run the run's clock
   */
  default Clock clock(Clock run) {
    return run;
  }

  /**
   * Where the service publishes.
   *
   * @param connection publishes on its connection
   */
  default Outlet outlet(Outlet connection) {
    return connection;
  }

  /**
   * Thread that the service regards as its own.
   *
   * @param own its actual thread
   */
  default int threadId(int own) {
    return own;
  }

  /**
   * Called when the service has connected, on the connecting thread.
   *
   * @param instance ID of the connection
   */
  default void connects(String instance) {}

  /** Called when the service is created but not started. */
  default void made(ServiceInstance service) {}

  /**
   * Takeover that a replayed service must perform; empty if none, or if its predecessor is running.
   */
  default Optional<Inheritance> inheritance() {
    return Optional.empty();
  }

  /**
   * Runs code of the service on the calling thread instead of the service's thread, which has not
   * been started.
   */
  default void onBehalf(Runnable code) {
    code.run();
  }

  /**
   * Called when the service has taken over from another one and is about to start.
   *
   * @param connection ID of its new connection
   */
  default void succeeds(Inheritance inheritance, String connection) {}

  /**
   * Runs code on the service's thread that is not part of the execution: the takeover by another
   * service.
   *
   * @return the code's result
   */
  default boolean apart(BooleanSupplier code) {
    return code.getAsBoolean();
  }

  /** Called when the service's thread starts. */
  default void begins() {}

  /** Called at each step. */
  default void steps() {}

  /**
   * Called when a message could be handled.
   *
   * @param waiting next message in the service's inbox; null if none
   * @return message to handle instead; null for none
   */
  default ServiceInbox.Delivery receives(ServiceInbox.Delivery waiting) {
    return waiting;
  }

  /** Whether {@link #receives} takes time that must not count as the service's own. */
  default boolean takesTime() {
    return false;
  }

  /**
   * Called when a written configuration change could be applied.
   *
   * @param isWritten whether one is waiting
   * @return whether to apply it now
   */
  default boolean takesWritten(BooleanSupplier isWritten) throws InterruptedException {
    return isWritten.getAsBoolean();
  }

  /** Called when the service's loop has ended, before its shutdown. */
  default void ends() {}

  /** Publishes frozen messages. */
  @FunctionalInterface
  interface Outlet {
    /**
     * Returns whether the message was accepted.
     *
     * @throws org.u2sa.interfaces.communication.CommunicationException if the service is not
     *     connected
     */
    boolean publish(Channel<?> channel, U2SAData message);
  }

  /**
   * Data passed to a service that takes over from another.
   *
   * @param serviceName common name of both
   * @param state state saved by the predecessor
   * @param firstStepMicros time of the predecessor's next step [µs of the run's clock]; empty if
   *     the first step is due immediately, or there are no steps
   */
  record Inheritance(String serviceName, HandOver state, OptionalLong firstStepMicros) {}
}
