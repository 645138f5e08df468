package org.u2sa.service;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/**
 * All that passes between one service's code and the world around it, in the order in which it
 * passes: readings of the clock, waits, messages that come and go. Whoever keeps it can execute the
 * service again, and get the same messages from it if the service depends on nothing else.
 *
 * <p>Called on the service's own thread, and before its start on the thread that makes it; only
 * {@link #clock} and {@link #publishes} may be called by others too.
 */
public interface Execution {
  /**
   * A service is about to be made; nothing of it has been opened yet.
   *
   * @throws org.u2sa.interfaces.BadInputException if a service of that role must not be made here
   */
  default void requireRole(ServiceRole role) {}

  /** The run's clock as the service is to see it. */
  Clock clock();

  /**
   * Which thread the service is to take itself for.
   *
   * @param own its own
   */
  int threadId(int own);

  /**
   * The service has connected, on whichever thread it first did.
   *
   * @param instance which connection it is
   */
  void connects(String instance);

  /** The service is made; its thread has not been started. */
  void made(U2SAService service);

  /**
   * The place of another service that a repeated service is to take; empty if it is to take none,
   * or that of a service that runs.
   */
  Optional<Inheritance> inheritance();

  /**
   * Runs code of the service on the calling thread, in place of the service's own, which has not
   * been started.
   */
  void onBehalf(Runnable code);

  /**
   * The service has taken the place of another one, and is about to be started.
   *
   * @param connection which connection it has now
   */
  void succeeds(Inheritance inheritance, String connection);

  /**
   * Runs, on the service's thread, what is not part of the execution: another service takes its
   * place.
   *
   * @return what the code returns
   */
  boolean apart(BooleanSupplier code);

  /** The service's thread begins. */
  void begins();

  /** The service steps. */
  void steps();

  /**
   * A message is to be handled, or could be.
   *
   * @param waiting the next of the service's inbox; null if none waits
   * @return what is to be handled in its place; null: nothing
   */
  Arrival receives(Arrival waiting);

  /**
   * A change of the configuration that was written is to be taken, or could be.
   *
   * @param isWritten whether one waits to be taken
   * @return whether it is to be taken now
   */
  boolean takesWritten(BooleanSupplier isWritten) throws InterruptedException;

  /**
   * A message is to be published.
   *
   * @param publish does so, and says whether the message was taken
   * @return whether the message counts as taken
   */
  boolean publishes(Channel<?> channel, U2SAData message, BooleanSupplier publish);

  /** The service's loop is over; what it does at its end follows. */
  void ends();

  /**
   * A message as it lies before a service.
   *
   * @param arrivedMicros when it came, where the service wants to know; otherwise 0 [µs]
   */
  record Arrival(Channel<?> channel, U2SAData message, long arrivedMicros) {}

  /**
   * What a service is given of the one whose place it takes.
   *
   * @param serviceName the name of both
   * @param state what the one before wrote down
   * @param firstStepMicros when the one before would have stepped [µs of the run's clock]; empty if
   *     the first step is due at once, or there are no steps
   */
  record Inheritance(String serviceName, HandOver state, OptionalLong firstStepMicros) {}

  /** A service that keeps the executions of those that are made after it, such as a recorder. */
  interface Keeper {
    /**
     * A service is going to be made.
     *
     * @param className its class
     * @param context all that it will be given, but for the execution itself
     * @return empty if it is not kept
     */
    Optional<Execution> keep(String className, ServiceContext context);
  }
}
