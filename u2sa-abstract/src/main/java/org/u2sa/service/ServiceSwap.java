package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/**
 * Replaces a running service by another one (thesis 5.1, user story 8) without losing a message or
 * handling one twice.
 *
 * <pre>
 *   caller's thread          new service made, not connected ── subscriptions that only it has
 *   old service's thread     … message │ handOver, takeOver, inbox, connection │ release, ends
 *   new service's thread                                                  starts │ begin, message …
 * </pre>
 *
 * <p>The new service is created with a context {@link ServiceContext.Builder#inPlaceOf in place of}
 * the old one. It gets the old one's name, log, connection and waiting messages, and the last
 * message of each retained channel. After a failure before {@link U2SAService#takeOver} has
 * returned, the old one continues.
 */
public final class ServiceSwap {
  private enum Stage {
    PREPARING,
    ORDERED,
    UNDER_WAY,
    DONE,
    REFUSED
  }

  private final U2SAService old;
  private final U2SAService successor;
  private final BooleanSupplier agreement;
  private final Succession.Order order = new Succession.Order(this::carryOut, this::refuse);
  private final CountDownLatch decided = new CountDownLatch(1);
  private volatile Stage stage = Stage.PREPARING; // writes guarded by this
  private volatile String refusal = "";
  private boolean prepared; // accessed by the ordering thread, later by one that refuses
  private volatile U2SAService waiting; // service whose thread awaits the outcome, or null

  /**
   * @param successor created with a context in place of the old service, and not started
   * @param agreement called on the old service's thread when the successor is about to run; false
   *     if it must end immediately because all services are ending
   */
  public ServiceSwap(U2SAService old, U2SAService successor, BooleanSupplier agreement) {
    this.old = old;
    this.successor = successor;
    this.agreement = agreement;
  }

  /**
   * Requests the swap, which happens after the old service has handled its current message. Returns
   * at once.
   */
  public ServiceSwap order() {
    Optional<String> obstacle = obstacle();
    if (obstacle.isPresent()) {
      refuse(Stage.PREPARING, obstacle.get());
    } else if (!old.succession.order(order)) {
      refuse(Stage.PREPARING, "it is already being swapped");
    } else {
      prepare();
    }
    return this;
  }

  private void prepare() {
    prepared = true;
    try {
      successor.connection.prepare(old.connection, successor.recipient);
    } catch (RuntimeException e) {
      refuse(Stage.PREPARING, "subscribing failed: " + e.getMessage());
      return;
    }
    move(Stage.PREPARING, Stage.ORDERED);
    old.life.wake();
    if (!old.isRunning()) { // ended before it saw the order
      refuse("it ended before");
    }
  }

  private Optional<String> obstacle() {
    if (!old.isRunning()) {
      return Optional.of("it is not running (" + old.status() + ")");
    }
    if (successor.role() != old.role()) {
      return Optional.of(
          String.format(
              "%s is a %s, expected a %s",
              successor.getClass().getName(), successor.role(), old.role()));
    }
    try {
      successor.context().configuration().refuseUndeclared();
    } catch (RuntimeException e) {
      return Optional.of(e.getMessage());
    }
    return Optional.empty();
  }

  /**
   * Waits until the swap is done or refused; on a service's own thread, on the run's clock.
   *
   * @param withinS timeout after which the request is withdrawn, because the old service may hang
   *     [s]
   * @return empty if the successor runs; otherwise the reason, and the old one continues
   * @throws InterruptedException if the calling thread was interrupted; the swap continues
   */
  public Optional<String> await(double withinS) throws InterruptedException {
    if (Clock.runningThread() instanceof U2SAService caller) {
      waiting = caller;
      caller.life.awaitUntil(this::isDecided, caller.clock().micros() + Clock.micros(withinS));
    } else {
      decided.await(Clock.micros(withinS), TimeUnit.MICROSECONDS);
    }
    if (!isDecided()) {
      refuse("it was busy with a message for more than " + withinS + " s");
      decided.await(); // a swap in progress ends soon
    }
    return outcome();
  }

  /** Whether the swap is done or refused. */
  public boolean isDecided() {
    return decided.getCount() == 0;
  }

  /** Result of {@link #await} once {@link #isDecided}. */
  public Optional<String> outcome() {
    return stage == Stage.REFUSED ? Optional.of(refusal) : Optional.empty();
  }

  private synchronized boolean move(Stage from, Stage to) {
    if (stage != from) {
      return false;
    }
    stage = to;
    return true;
  }

  private void refuse(String reason) {
    refuse(Stage.ORDERED, reason);
  }

  private void refuse(Stage from, String reason) {
    synchronized (this) {
      if (stage != from) {
        return;
      }
      stage = Stage.REFUSED;
      refusal = reason;
    }
    if (prepared) {
      old.connection.forget(successor.connection);
    }
    old.succession.forget(order);
    old.log(
        LogLevelEnum.WARN,
        "not swapped for " + successor.getClass().getName() + ": " + reason + ": keeps running");
    discardSuccessor();
    decide();
  }

  private void decide() {
    decided.countDown();
    U2SAService caller = waiting;
    if (caller != null) {
      caller.life.wake();
    }
  }

  /** Executes the swap on the old service's thread between two messages; returns whether it did. */
  private boolean carryOut() {
    if (old.configurationWriter.isBusy()) {
      return false; // not yet: the service is woken when the change is written
    }
    if (!move(Stage.ORDERED, Stage.UNDER_WAY)) {
      return false;
    }
    return old.context().execution().apart(this::change);
  }

  private boolean change() {
    if (old.context().configuration().revision()
        != successor.context().configuration().revision()) {
      refuse(
          Stage.UNDER_WAY, "its configuration was changed during the swap; order the swap again");
      return false;
    }
    Optional<HandOver> values = handOver();
    if (!values.isPresent()) {
      return false;
    }
    if (!old.connection.moveTo(successor.connection)) {
      refuse(Stage.UNDER_WAY, "it ended during the swap");
      return false;
    }
    old.recipient.inbox().moveTo(successor.recipient.inbox(), old.succession.retained());
    old.life.succeededBy(successor.life);
    old.connection.receiver().turnTo(successor.recipient);
    successor.succeeds(old);
    boolean agreed = agreement.getAsBoolean();
    releaseForSuccessor(old);
    if (agreed) {
      old.log("handed over to " + successor.getClass().getName());
      successor
          .context()
          .execution()
          .succeeds(
              new Execution.Inheritance(
                  old.getServiceName(), values.get(), successor.firstStepMicros()),
              successor.connection.instance().orElse(""));
      startSuccessor();
    } else {
      successor.shutDown();
    }
    if (old.life.isAskedToStop()) { // told to stop during the hand-over
      successor.life.askToStop();
    }
    move(Stage.UNDER_WAY, Stage.DONE);
    decide();
    successor.connection.dropSubscriptionsOnlyOf(old.connection);
    return true;
  }

  /** Starts the successor's thread; if that fails, it ends as if it had died. */
  private void startSuccessor() {
    try {
      successor.start();
    } catch (RuntimeException | Error e) {
      successor.life.die(e);
    }
  }

  /** Ends the successor without having run, because its predecessor continues. */
  private void discardSuccessor() {
    if (successor.life.endsNow()) {
      successor.connection.silence();
      releaseForSuccessor(successor);
      successor.context().forgetPredecessor();
    }
  }

  private static void releaseForSuccessor(U2SAService service) {
    if (service.loop != null) {
      service.loop.close();
    }
    service.life.atLast("closing", service::releaseToSuccessor);
  }

  private Optional<HandOver> handOver() {
    try {
      HandOver values = old.handedOver();
      successor.succession.takeOver(values);
      return Optional.of(values);
    } catch (Exception | Error e) { // thrown by the author's code
      old.logFile().log(LogLevelEnum.ERROR, "handing over failed", e);
      refuse(Stage.UNDER_WAY, "handing over failed: " + e);
      return Optional.empty();
    }
  }
}
