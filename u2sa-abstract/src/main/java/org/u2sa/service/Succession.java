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
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Succession of services: takeover by another class at run time (user story 8), and restarts with
 * saved state.
 */
final class Succession {
  private static final int KEPT_OF_EVERY = 64;

  private final U2SAService service;
  private final ProgressFile progress;
  private final AtomicReference<ServiceSwap> ordered = new AtomicReference<>();
  private final Map<String, Map<String, Deque<ServiceInbox.Delivery>>> retained =
      new LinkedHashMap<>(); // latest by channel and source; confined to the service's thread
  private volatile U2SAService successor; // written on the service's thread
  private boolean hasPredecessor; // in this process
  private long notRemembered;

  Succession(U2SAService service, ServiceContext context) {
    this.service = service;
    progress = new ProgressFile(context, service.getServiceName());
  }

  /** Before the first start: restores the state saved before a restart, or deletes it. */
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
        progress.delete(); // left by another run
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

  /** Restores the predecessor's saved state, on the predecessor's thread. */
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
      return; // abandoned or replaced: its successor saves now
    }
    try {
      HandOver state = new HandOver(service.getClass().getName());
      service.handOver(state);
      progress.write(state);
    } catch (IOException | RuntimeException e) { // such as a full disk: not fatal
      notRemembered++;
      if (Long.bitCount(notRemembered) == 1) { // 1, 2, 4, 8…: may persist
        service.log(
            LogLevelEnum.ERROR,
            "the state was not saved, a restart would not resume from here: " + e);
      }
    }
  }

  /** Records an order. Returns false if one is pending. */
  boolean order(ServiceSwap swap) {
    return ordered.compareAndSet(null, swap);
  }

  /** Discards a failed order. */
  void forget(ServiceSwap swap) {
    ordered.compareAndSet(swap, null);
  }

  /**
   * Executes a pending order; call it on the service's thread between two messages.
   *
   * @return whether another service has taken over
   */
  boolean carryOut() {
    ServiceSwap swap = ordered.get();
    return swap != null && swap.carryOut();
  }

  /**
   * Records a handled message. A successor gets the last messages of retained channels again, as if
   * it had newly subscribed, without involving the Communication Manager. On channels that must not
   * lose messages several are kept, because the last one may be meaningless alone, such as a clear
   * of an older stop.
   */
  void note(ServiceInbox.Delivery delivery) {
    if (!delivery.channel().isRetained()) {
      return;
    }
    Map<String, Deque<ServiceInbox.Delivery>> ofChannel =
        retained.computeIfAbsent(delivery.channel().name(), name -> new LinkedHashMap<>());
    String source = delivery.channel().sourceOf(delivery.message());
    Deque<ServiceInbox.Delivery> before = ofChannel.remove(source);
    Deque<ServiceInbox.Delivery> ofSource = before == null ? new ArrayDeque<>() : before;
    ofChannel.put(source, ofSource); // last, so that the first is the one silent for longest
    if (ofChannel.size() > ServiceInbox.MAX_SOURCES) {
      ofChannel.remove(ofChannel.keySet().iterator().next());
    }
    ofSource.add(delivery);
    if (ofSource.size() > (delivery.channel().deliversEvery() ? KEPT_OF_EVERY : 1)) {
      ofSource.remove();
    }
  }

  /** The last messages of retained channels; those of one source in handling order. */
  List<ServiceInbox.Delivery> retained() {
    List<ServiceInbox.Delivery> all = new ArrayList<>();
    retained.values().forEach(ofChannel -> ofChannel.values().forEach(all::addAll));
    return all;
  }

  /** Records that the successor has taken over. */
  void succeeded(U2SAService by) {
    successor = by;
  }

  /** The successor that has taken over. */
  Optional<U2SAService> successor() {
    return Optional.ofNullable(successor);
  }

  /** Records that this service has taken over from another. */
  void succeeds() {
    hasPredecessor = true;
    service.context().forgetPredecessor();
  }

  /** Whether another service has taken over with all resources, so that no shutdown is needed. */
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

  /**
   * Closes the subclass's resources but leaves actuators as they are, because the successor moves
   * them.
   */
  void releaseAsPredecessor() {
    if (service.loop != null) {
      service.loop.close();
    }
    service.life.atLast("closing", service::releaseToSuccessor);
  }

  /** Ends without having run, because its predecessor continues. */
  void discard() {
    if (service.life.endsNow()) {
      service.wiring.silence();
      releaseAsPredecessor();
      service.context().forgetPredecessor();
    }
  }
}
