package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** What a swap that is refused leaves behind, what one that is done says, and who waits for it. */
@Timeout(120)
class RefusedSwapTest {
  private final ServiceKit kit = new ServiceKit();
  private final Counting old = kit.start(Counting::new);

  @AfterEach
  void close() {
    kit.close();
  }

  private ServiceContext inPlaceOf(XmlConfiguration configuration) {
    return ServiceContext.of(ServiceKit.SYSTEM_ID, configuration)
        .clock(kit.clock())
        .transport(kit.bus())
        .logDirectory(old.context().logDirectory())
        .inPlaceOf(old)
        .build();
  }

  private XmlConfiguration configuration() {
    return old.context().configuration().forSuccessor();
  }

  /** One that also listens to changes of goals, which the old one does not. */
  private Counting hearingMore() {
    Counting successor = new Counting(inPlaceOf(configuration()));
    successor.registerSubscriber(Channels.GOAL_UPDATES);
    return successor;
  }

  private ServiceSwap order(U2SAService successor) {
    ServiceSwap swap = new ServiceSwap(old, successor, () -> true).order();
    kit.settle();
    return swap;
  }

  private void update() {
    kit.publish(Channels.GOAL_UPDATES, new Waypoint().horizontalThreshold(1.0).uid("a"));
  }

  private static boolean has(ServiceKit kit, String part) {
    return kit.log("Counting").stream().anyMatch(line -> line.contains(part));
  }

  @Test
  void order_successorWithAVariableThatItDoesNotDeclare_isRefused() {
    XmlConfiguration misspelt = configuration();
    misspelt.override("LOG LEVLE", "DEBUG");

    ServiceSwap swap = order(new Counting(inPlaceOf(misspelt)));

    assertThat(swap.outcome())
        .hasValueSatisfying(
            why -> assertThat(why).contains("\"LOG LEVLE\": no service declares it"));
    assertThat(old.isRunning()).isTrue();
    assertThat(has(kit, "not swapped for " + Counting.class.getName())).isTrue();
  }

  @Test
  void order_handOverFails_dropsWhatOnlyTheSuccessorWantedAndLogsTheFault() {
    Counting successor = hearingMore();
    old.inHandOver(
        state -> {
          throw new IllegalStateException("half a state");
        });

    assertThat(order(successor).outcome())
        .contains("handing over failed: java.lang.IllegalStateException: half a state");
    update();

    assertThat(old.order()).doesNotContain("Waypoint");
    assertThat(has(kit, "ERROR")).isTrue();
    assertThat(has(kit, "handing over failed")).isTrue();
    assertThat(successor.status()).isEqualTo(ServiceStatus.STOPPED);
  }

  @Test
  void order_done_isLoggedAndTheSuccessorHearsWhatItWantsOnly() {
    Counting successor = hearingMore();

    assertThat(order(successor).outcome()).isEmpty();
    update();

    assertThat(successor.order()).endsWith("Waypoint");
    assertThat(has(kit, "handed over to " + Counting.class.getName())).isTrue();
    assertThat(has(kit, "not swapped")).isFalse();
  }

  /** Listens to less than {@link Counting}. */
  private static final class Deaf extends EventDrivenService {
    private int heard;

    Deaf(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Counting");
    }

    @Override
    public void callback(U2SAData data) {
      heard++;
    }
  }

  @Test
  void order_successorThatWantsLess_hearsNoMoreWhatOnlyTheOldOneWanted() {
    Deaf successor = new Deaf(inPlaceOf(configuration()));

    assertThat(order(successor).outcome()).isEmpty();
    int heard = successor.heard;
    kit.publish(Channels.GOALS, new GoalList());

    assertThat(successor.heard).isEqualTo(heard);
    successor.kill();
  }

  /** Orders the swap on its own thread and waits there for what comes of it. */
  private static final class Launcher extends EventDrivenService {
    private final ServiceSwap swap;
    private Optional<String> outcome;

    Launcher(ServiceContext context, ServiceSwap swap) {
      super(context, ServiceRole.OBSERVER, "Launcher");
      this.swap = swap;
      registerSubscriber(Channels.GOAL_UPDATES);
    }

    @Override
    public void callback(U2SAData data) {
      try {
        outcome = swap.order().await(2.0);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @Test
  void await_onAServicesThread_returnsAsSoonAsItIsDone() {
    Counting successor = new Counting(inPlaceOf(configuration()));
    Launcher launcher =
        kit.start(context -> new Launcher(context, new ServiceSwap(old, successor, () -> true)));

    update();

    assertThat(launcher.outcome).isEmpty();
    assertThat(successor.isRunning()).isTrue();
    successor.kill();
  }
}
