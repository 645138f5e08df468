package org.u2sa.service;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * Hook into everything that passes between a service's code and its environment, in order: clock
 * readings, waits, messages in and out. Recording it allows the service to be re-executed; it then
 * publishes the same messages if it depends on nothing else.
 *
 * <p>Called on the service's thread, and before its start on the thread that creates it; only
 * {@link #clock} and {@link #publishes} may be called on other threads.
 */
public interface Execution {
  /**
   * Called before a service is created and opens any resource.
   *
   * @throws org.u2sa.interfaces.BadInputException if a service of this role must not be created
   *     here
   */
  default void requireRole(ServiceRole role) {}

  /** The run's clock as seen by the service. */
  Clock clock();

  /**
   * Thread that the service regards as its own.
   *
   * @param own its actual thread
   */
  int threadId(int own);

  /**
   * Called when the service has connected, on the connecting thread.
   *
   * @param instance ID of the connection
   */
  void connects(String instance);

  /** Called when the service is created but not started. */
  void made(U2SAService service);

  /**
   * Takeover that a replayed service must perform; empty if none, or if its predecessor is running.
   */
  Optional<Inheritance> inheritance();

  /**
   * Runs code of the service on the calling thread instead of the service's thread, which has not
   * been started.
   */
  void onBehalf(Runnable code);

  /**
   * Called when the service has taken over from another one and is about to start.
   *
   * @param connection ID of its new connection
   */
  void succeeds(Inheritance inheritance, String connection);

  /**
   * Runs code on the service's thread that is not part of the execution: the takeover by another
   * service.
   *
   * @return the code's result
   */
  boolean apart(BooleanSupplier code);

  /** Called when the service's thread starts. */
  void begins();

  /** Called at each step. */
  void steps();

  /**
   * Called when a message could be handled.
   *
   * @param waiting next message in the service's inbox; null if none
   * @return message to handle instead; null for none
   */
  Arrival receives(Arrival waiting);

  /**
   * Called when a written configuration change could be applied.
   *
   * @param isWritten whether one is waiting
   * @return whether to apply it now
   */
  boolean takesWritten(BooleanSupplier isWritten) throws InterruptedException;

  /**
   * Called to publish a message.
   *
   * @param publish publishes it and returns whether it was accepted
   * @return whether the message counts as accepted
   */
  boolean publishes(Channel<?> channel, U2SAData message, BooleanSupplier publish);

  /** Called when the service's loop has ended, before its shutdown. */
  void ends();

  /**
   * A message as delivered to a service.
   *
   * @param arrivedMicros time of arrival if the service needs it; otherwise 0 [µs]
   */
  record Arrival(Channel<?> channel, U2SAData message, long arrivedMicros) {}

  /**
   * Data passed to a service that takes over from another.
   *
   * @param serviceName common name of both
   * @param state state saved by the predecessor
   * @param firstStepMicros time of the predecessor's next step [µs of the run's clock]; empty if
   *     the first step is due immediately, or there are no steps
   */
  record Inheritance(String serviceName, HandOver state, OptionalLong firstStepMicros) {}

  /** Records the executions of services created after it, such as a recorder. */
  interface Keeper {
    /**
     * Called before a service is created.
     *
     * @param className class of the service
     * @param context its context, without the execution
     * @return empty if it is not recorded
     */
    Optional<Execution> keep(String className, ServiceContext context);
  }
}
