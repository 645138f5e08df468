package org.u2sa.service;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ContractOrders;
import org.u2sa.service.inbox.ServiceInbox;

/** Takeover by another class at run time (user story 8), and restarts with saved state. */
final class Succession {
  private static final int KEPT_OF_EVERY = 64;

  private final ServiceContext context;
  private final ServiceConfiguration configuration;
  private final Consumer<HandOver> takeOver;
  private final LongConsumer firstStepAt;
  private final Consumer<String> remark;
  private final ProgressFile progress;
  private final ProgressFile orderFile;
  private final ContractOrders orders = new ContractOrders(this::saveOrders);
  private final AtomicReference<Order> ordered = new AtomicReference<>();
  private final Map<String, Map<String, Deque<ServiceInbox.Delivery>>> retained =
      new LinkedHashMap<>(); // latest by channel and source; confined to the service's thread
  private boolean hasPredecessor; // in this process
  private final AtomicLong notRemembered = new AtomicLong();

  /**
   * An ordered swap.
   *
   * @param carryOut returns whether another service has taken over
   * @param refuse refuses it for a reason, unless it is being carried out
   */
  record Order(BooleanSupplier carryOut, Consumer<String> refuse) {}

  /**
   * @param takeOver restores saved state
   * @param firstStepAt sets when the first step is due [µs of the run's clock]
   * @param remark receives why the state is not saved, for health reports; empty if it is
   */
  Succession(
      ServiceContext context,
      ServiceConfiguration configuration,
      Consumer<HandOver> takeOver,
      LongConsumer firstStepAt,
      Consumer<String> remark) {
    this.context = context;
    this.configuration = configuration;
    this.takeOver = takeOver;
    this.firstStepAt = firstStepAt;
    this.remark = remark;
    progress = new ProgressFile(context, configuration.name());
    orderFile = new ProgressFile(context, configuration.name() + ".orders");
    resumeOrders();
  }

  /** Orders to stop and to change variables. */
  ContractOrders orders() {
    return orders;
  }

  /** Before the service is connected, because an order may arrive a second time at once. */
  private void resumeOrders() {
    boolean isRepeated = configuration.execution().inheritance().isPresent();
    if (isRepeated || !context.isRestart() && !context.isSwap()) {
      return;
    }
    try {
      orderFile.read().ifPresent(orders::takeOver);
    } catch (IOException | RuntimeException e) {
      ordersUnknown("orders that came before the restart are not known: ", e);
    }
  }

  private void saveOrders(HandOver state) {
    orderFile.write(state, () -> {}, e -> ordersUnknown("orders are not saved: ", e));
  }

  private void ordersUnknown(String what, Exception why) {
    configuration.log(LogLevelEnum.WARN, what + why.getMessage());
  }

  /** Before the first start: restores the state saved before a restart, or deletes it. */
  void resume() {
    if (hasPredecessor) {
      return;
    }
    Optional<Execution.Inheritance> repeated = configuration.execution().inheritance();
    if (repeated.isPresent()) {
      takeOver(repeated.get().state());
      repeated.get().firstStepMicros().ifPresent(firstStepAt);
      return;
    }
    try {
      Optional<HandOver> before = context.isRestart() ? progress.read() : Optional.empty();
      if (before.isPresent()) {
        resumeFrom(before.get());
      } else {
        progress.delete(this::startsFresh); // left by another run
      }
      if (!context.isRestart()) {
        orderFile.delete(e -> ordersUnknown("orders of an earlier run were not deleted: ", e));
      }
    } catch (IOException e) {
      startsFresh(e);
    }
  }

  private void startsFresh(IOException why) {
    configuration.log(LogLevelEnum.ERROR, "no saved state, starting fresh: " + why.getMessage());
  }

  private void resumeFrom(HandOver before) {
    try {
      takeOver.accept(before);
      configuration.log(LogLevelEnum.INFO, "resumes its state from before the restart");
    } catch (RuntimeException e) {
      configuration.log().log(LogLevelEnum.ERROR, "cannot resume from " + progress.path(), e);
      progress.delete(this::startsFresh);
      throw e;
    }
  }

  /** Restores the predecessor's saved state, on the predecessor's thread. */
  void takeOver(HandOver before) {
    configuration.execution().onBehalf(() -> takeOver.accept(before));
  }

  /** {@link U2SAService#remember}. */
  void remember(Supplier<HandOver> state) {
    try {
      progress.write(state.get(), () -> remark.accept(""), this::notRemembered);
    } catch (RuntimeException e) {
      notRemembered(e);
    }
  }

  /** Reports that saving failed, e.g. because the disk is full; not fatal. */
  private void notRemembered(Exception why) {
    remark.accept("not saved: " + why);
    if (Long.bitCount(notRemembered.incrementAndGet()) == 1) { // 1, 2, 4, 8…: may persist
      configuration.log(
          LogLevelEnum.ERROR,
          "the state was not saved; a restart would not resume from here: " + why);
    }
  }

  boolean order(Order swap) {
    return ordered.compareAndSet(null, swap);
  }

  void forget(Order swap) {
    ordered.compareAndSet(swap, null);
  }

  /**
   * Executes a pending order between two messages; returns whether another service has taken over.
   */
  boolean carryOut() {
    Order swap = ordered.get();
    return swap != null && swap.carryOut.getAsBoolean();
  }

  void refuse(String reason) {
    Order swap = ordered.get();
    if (swap != null) {
      swap.refuse.accept(reason);
    }
  }

  /**
   * Records a handled message. A successor gets the last messages of retained channels again, as if
   * it had newly subscribed. Channels that must not lose messages keep several, because the last
   * one may be meaningless alone, such as a clear of an older stop.
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

  /** The last messages on retained channels; messages of one source are in handling order. */
  List<ServiceInbox.Delivery> retained() {
    List<ServiceInbox.Delivery> all = new ArrayList<>();
    retained.values().forEach(ofChannel -> ofChannel.values().forEach(all::addAll));
    return all;
  }

  void succeeds() {
    hasPredecessor = true;
    context.forgetPredecessor();
  }
}
