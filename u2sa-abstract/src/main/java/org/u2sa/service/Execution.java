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
 * readings, waits, messages in and out. Recording it allows the service to be re-executed. By
 * default, no method has an effect.
 *
 * <p>Called on the service's thread, and before its start on the thread that creates it; only what
 * {@link #clock} and {@link #outlet} return may be used on other threads.
 */
public interface Execution {
  Execution NONE = new Execution() {};

  /**
   * Called before a service is created and opens any resource.
   *
   * @throws org.u2sa.interfaces.BadInputException if a service of this role must not be created
   *     here
   */
  default void requireRole(ServiceRole role) {}

  /** The run's clock as seen by the service. */
  default Clock clock(Clock run) {
    return run;
  }

  /** Output to which the service publishes instead of its connection. */
  default Outlet outlet(Outlet connection) {
    return connection;
  }

  /** ID that the service regards as its thread ID. */
  default int threadId(int own) {
    return own;
  }

  /** Called on the connecting thread, with the ID of the connection. */
  default void connects(String instance) {}

  /** Called when the service is created but not started. */
  default void made(ServiceInstance service) {}

  /** Takeover that a replayed service must perform, unless its predecessor is running. */
  default Optional<Inheritance> inheritance() {
    return Optional.empty();
  }

  /** Runs code of the service on the calling thread, before the service's thread has started. */
  default void onBehalf(Runnable code) {
    code.run();
  }

  /**
   * Called when the service has taken over and is about to start, with the ID of its new
   * connection.
   */
  default void succeeds(Inheritance inheritance, String connection) {}

  /**
   * Runs code on the service's thread that is not part of the execution: the takeover by another
   * service.
   */
  default boolean apart(BooleanSupplier code) {
    return code.getAsBoolean();
  }

  /** Called when the service's thread starts. */
  default void begins() {}

  /** Called at each step. */
  default void steps() {}

  /**
   * Called when a message could be handled; returns the one to handle.
   *
   * @param waiting next message in the inbox; null if none
   */
  default ServiceInbox.Delivery receives(ServiceInbox.Delivery waiting) {
    return waiting;
  }

  /** Whether {@link #receives} takes time that must not count as the service's own. */
  default boolean takesTime() {
    return false;
  }

  /** Whether to apply a written configuration change now, if one is waiting. */
  default boolean takesWritten(BooleanSupplier isWritten) throws InterruptedException {
    return isWritten.getAsBoolean();
  }

  /**
   * Whether the service may write the files that its configuration names: not in a re-execution,
   * whose configuration is the recording's.
   */
  default boolean writesNamedFiles() {
    return true;
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
   * @param firstStepMicros time of the predecessor's next step [µs of the run's clock]; empty if
   *     immediately or never
   */
  record Inheritance(String serviceName, HandOver state, OptionalLong firstStepMicros) {}
}
