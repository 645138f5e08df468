package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Semaphore;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.U2SAData;

/** Many swaps in real time: no message is lost, none handled twice, nothing is left behind. */
@Timeout(120)
class ServiceSwapStressTest {
  private static final int MESSAGES = 300_000;
  private static final int SWAPS = 60;

  @TempDir private Path logs;
  private final LocalBus bus = new LocalBus("stress");

  /** Keeps numbers only, as many as come. */
  private static final class Numbers extends EventDrivenService {
    private final List<Integer> handled = new ArrayList<>(); // of this instance, in order

    Numbers(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Numbers");
      registerSubscriber(Counting.NUMBERS);
    }

    @Override
    public void callback(U2SAData data) {
      handled.add(Integer.valueOf(((GoalCommand) data).uid()));
    }
  }

  /** Publishes and hears nothing. */
  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {}

    @Override
    public void trouble(String what) {
      throw new AssertionError(what);
    }
  }

  private ServiceContext.Builder context(XmlConfiguration configuration) {
    return ServiceContext.of("stress", configuration)
        .clock(new SystemClock())
        .transport(bus)
        .logDirectory(logs);
  }

  private Numbers begin() {
    XmlConfiguration configuration =
        XmlConfiguration.inMemory("Numbers", Map.of("INBOX CAPACITY", 1_000_000));
    Numbers first = new Numbers(context(configuration).build());
    first.start();
    return first;
  }

  private Numbers swap(Numbers old) throws InterruptedException {
    Numbers next =
        new Numbers(context(old.context().configuration().forSuccessor()).inPlaceOf(old).build());
    Optional<String> refusal = new ServiceSwap(old, next, () -> true).order().await(30.0);
    assertThat(refusal).isEmpty();
    return next;
  }

  @Test
  void swap_publisherAtFullRate_eachMessageIsHandledOnceInOrder() throws Exception {
    List<Numbers> all = new ArrayList<>(List.of(begin()));
    Semaphore due = new Semaphore(0); // so that there is something to publish at every swap
    CompletableFuture<Void> published =
        CompletableFuture.runAsync(
            () -> {
              try (Connection publisher = bus.connect("publisher", new Deaf())) {
                for (int i = 0; i < MESSAGES; i++) {
                  GoalCommand message = new GoalCommand().uid(Integer.toString(i));
                  message.freeze();
                  due.acquireUninterruptibly();
                  assertThat(publisher.publish(Counting.NUMBERS, message)).isTrue();
                }
              }
            });
    while (all.size() <= SWAPS || !published.isDone()) {
      due.release(MESSAGES / SWAPS);
      all.add(swap(all.get(all.size() - 1)));
    }
    published.get();
    Numbers last = all.get(all.size() - 1);
    last.kill();
    while (last.recipient.inbox().depth() > 0) { // what it had not handled when it was killed
      last.callback(last.recipient.inbox().poll().message());
    }

    List<Integer> handled = new ArrayList<>();
    all.forEach(service -> handled.addAll(service.handled));
    assertThat(last.recipient.inbox().dropped()).isZero();
    assertThat(handled).hasSize(MESSAGES);
    for (int i = 0; i < MESSAGES; i++) {
      assertThat(handled.get(i)).isEqualTo(i);
    }
    assertThat(all).filteredOn(service -> !service.handled.isEmpty()).hasSizeGreaterThan(1);
  }

  @Test
  void swap_thousandTimes_leavesNoThreadAndNoService() throws Exception {
    Numbers present = begin();
    List<java.lang.ref.WeakReference<Numbers>> before = new ArrayList<>();
    for (int i = 0; i < 1_000; i++) {
      before.add(new java.lang.ref.WeakReference<>(present));
      present = swap(present);
    }
    for (java.lang.ref.WeakReference<Numbers> each : before) {
      Numbers ended = each.get();
      if (ended != null) {
        ended.join();
      }
    }

    long threads =
        Thread.getAllStackTraces().keySet().stream()
            .filter(thread -> thread.getName().equals("Numbers"))
            .count();
    assertThat(threads).isEqualTo(1);
    System.gc(); // without a promise; but a chain of a thousand would stay whole
    assertThat(before).filteredOn(each -> each.get() != null).hasSizeLessThan(500);
    assertThat(present.isRunning()).isTrue();
    present.kill();
  }
}
