package org.u2sa.service;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.interfaces.log.LogLevelEnum;

/**
 * How a service goes on where another one was, and another one where it was: a service of another
 * class while it runs (user story 8), or itself before it was started anew.
 */
final class Succession {
  private static final int KEPT_OF_EVERY = 64;

  private final U2SAService service;
  private final ProgressFile progress;
  private final AtomicReference<ServiceSwap> ordered = new AtomicReference<>();
  private final Map<String, Map<String, Deque<ServiceInbox.Delivery>>> retained =
      new LinkedHashMap<>(); // newest by channel and source; belongs to the service's thread
  private volatile U2SAService successor; // written on the service's thread
  private boolean hasPredecessor; // whose place it has in this process
  private long notRemembered;

  Succession(U2SAService service, ServiceContext context) {
    this.service = service;
    progress = new ProgressFile(context, service.getServiceName());
  }

  /** Before the first start: takes up what was remembered before a restart, or forgets it. */
  void resume() {
    if (hasPredecessor) {
      return;
    }
    Optional<Execution.Inheritance> repeated = service.context().inheritance();
    if (repeated.isPresent()) {
      takeOver(repeated.get().state());
      repeated.get().firstStepMicros().ifPresent(service::firstStepAt);
      return;
    }
    try {
      Optional<HandOver> before =
          service.context().isRestart() ? progress.read() : Optional.empty();
      if (before.isPresent()) {
        resumeFrom(before.get());
      } else {
        progress.delete(); // of another run
      }
    } catch (IOException e) {
      service.log(LogLevelEnum.ERROR, "no saved state, starting fresh: " + e.getMessage());
    }
  }

  private void resumeFrom(HandOver before) throws IOException {
    try {
      service.takeOver(before);
      service.log("resumes where it was before the restart");
    } catch (RuntimeException e) {
      service.logFile().log(LogLevelEnum.ERROR, "cannot resume from " + progress.path(), e);
      progress.delete();
      throw e;
    }
  }

  /** Takes over what the service before wrote down, on that one's thread. */
  void takeOver(HandOver before) {
    Optional<Execution> execution = service.context().execution();
    if (execution.isPresent()) {
      execution.get().onBehalf(() -> service.takeOver(before));
    } else {
      service.takeOver(before);
    }
  }

  /** {@link U2SAService#remember}. */
  void remember() {
    if (!service.isRunning() || service.wiring.isSilent()) {
      return; // given up or replaced: another one remembers now
    }
    try {
      HandOver state = new HandOver(service.getClass().getName());
      service.handOver(state);
      progress.write(state);
    } catch (IOException | RuntimeException e) { // such as a full disk: no reason not to go on
      notRemembered++;
      if (Long.bitCount(notRemembered) == 1) { // 1, 2, 4, 8…: it may last
        service.log(
            LogLevelEnum.ERROR,
            "the state was not saved, a restart would not resume from here: " + e);
      }
    }
  }

  /** Takes note of an order. Returns false if there is one already. */
  boolean order(ServiceSwap swap) {
    return ordered.compareAndSet(null, swap);
  }

  /** Forgets an order that came to nothing. */
  void forget(ServiceSwap swap) {
    ordered.compareAndSet(swap, null);
  }

  /**
   * Carries an order out, if there is one; to be called on the service's thread between two
   * messages.
   *
   * @return whether another service has taken the place
   */
  boolean carryOut() {
    ServiceSwap swap = ordered.get();
    return swap != null && swap.carryOut();
  }

  /**
   * Takes note that a message is being handled. On retained channels a successor is handed the last
   * ones again, as if it subscribed anew, without asking the Communication Manager. Where each
   * message matters, several are kept, since the last one may mean nothing alone, as an order to
   * clear an older stop.
   */
  void note(ServiceInbox.Delivery delivery) {
    if (!delivery.channel().isRetained()) {
      return;
    }
    Deque<ServiceInbox.Delivery> ofSource =
        retained
            .computeIfAbsent(delivery.channel().name(), name -> new LinkedHashMap<>())
            .computeIfAbsent(
                delivery.channel().sourceOf(delivery.message()), source -> new ArrayDeque<>());
    ofSource.add(delivery);
    if (ofSource.size() > (delivery.channel().deliversEvery() ? KEPT_OF_EVERY : 1)) {
      ofSource.remove();
    }
  }

  /** The last messages of retained channels, of one source in the order of their handling. */
  List<ServiceInbox.Delivery> retained() {
    List<ServiceInbox.Delivery> all = new ArrayList<>();
    retained.values().forEach(ofChannel -> ofChannel.values().forEach(all::addAll));
    return all;
  }

  /** The place is the successor's from now on. */
  void succeeded(U2SAService by) {
    successor = by;
  }

  /** Who has taken the place. */
  Optional<U2SAService> successor() {
    return Optional.ofNullable(successor);
  }

  /** Takes note that this service has another one's place. */
  void succeeds() {
    hasPredecessor = true;
    service.context().forgetPredecessor();
  }

  /** Whether another service has the place and all that belongs to it, so that there is no end. */
  boolean handsOverInsteadOfEnding() {
    if (successor != null) {
      return true;
    }
    ServiceSwap swap = ordered.get();
    if (swap != null) {
      swap.refuse("it ended before");
    }
    return false;
  }

  /** Closes what the subclass opened, but leaves actuators as they are: a successor moves them. */
  void releaseAsPredecessor() {
    if (service.loop != null) {
      service.loop.close();
    }
    service.life.atLast("closing", service::releaseToSuccessor);
  }

  /** Ends without ever having run, because its predecessor goes on. */
  void discard() {
    if (service.life.endsNow()) {
      service.wiring.silence();
      releaseAsPredecessor();
      service.context().forgetPredecessor();
    }
  }
}
