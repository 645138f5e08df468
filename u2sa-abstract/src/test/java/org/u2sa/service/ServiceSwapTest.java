package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** One service takes the place of another, or does not. */
@Timeout(120)
class ServiceSwapTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();
  private final Counting old = kit.start(Counting::new);

  private ServiceContext inPlaceOf(U2SAService service) {
    return inPlaceOf(service, service.context().configuration().forSuccessor());
  }

  private ServiceContext inPlaceOf(U2SAService service, XmlConfiguration configuration) {
    return ServiceContext.of(ServiceKit.SYSTEM_ID, configuration)
        .clock(kit.clock())
        .transport(kit.bus())
        .logDirectory(service.context().logDirectory())
        .inPlaceOf(service)
        .build();
  }

  private ServiceSwap order(U2SAService successor) {
    ServiceSwap swap = new ServiceSwap(old, successor, () -> true).order();
    kit.settle();
    return swap;
  }

  private <S extends U2SAService> S make(Function<ServiceContext, S> constructor) {
    return constructor.apply(inPlaceOf(old));
  }

  private Optional<String> swap(U2SAService successor) {
    ServiceSwap swap = order(successor);
    assertThat(swap.isDecided()).isTrue();
    return swap.outcome();
  }

  private void number(int number) {
    kit.send(Counting.NUMBERS, new GoalCommand().uid("n" + number));
  }

  @Test
  void swap_messagesWaiting_areHandledOnceByOldOrNew() throws InterruptedException {
    number(1);
    kit.settle();
    Counting successor = make(Counting::new);
    number(2);
    ServiceSwap swap = new ServiceSwap(old, successor, () -> true).order();
    number(3);
    kit.settle();
    number(4);
    kit.settle();

    assertThat(swap.outcome()).isEmpty();
    assertThat(successor.handled).containsExactly("n1", "n2", "n3", "n4");
    assertThat(old.handled).containsExactly("n1");
    old.join();
    assertThat(successor.isRunning()).isTrue();
  }

  /** Heeds stops as well. */
  private static final class Stoppable extends EventDrivenService {
    private final List<String> handled = new ArrayList<>();

    Stoppable(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Stoppable");
      registerSubscriber(Channels.EMERGENCY_STOP);
      registerSubscriber(Counting.NUMBERS);
    }

    @Override
    public void callback(U2SAData data) {
      handled.add(
          data instanceof EmergencyStop stop
              ? stop.stopId().orElseThrow()
              : ((GoalCommand) data).uid());
    }
  }

  @Test
  void swap_urgentMessagesWaiting_areHandledByTheNewOneFirst() {
    Stoppable before = kit.start(Stoppable::new);
    Stoppable successor = new Stoppable(inPlaceOf(before));
    number(1);
    for (int i = 1; i <= 3; i++) {
      kit.send(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("s" + i));
    }
    ServiceSwap swap = new ServiceSwap(before, successor, () -> true).order();
    number(2);
    kit.send(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("s4"));
    kit.settle();

    assertThat(swap.outcome()).isEmpty();
    assertThat(before.handled).isEmpty();
    assertThat(successor.handled).containsExactly("s1", "s2", "s3", "s4", "n1", "n2");
    successor.kill();
  }

  @Test
  void swap_configurationChangedSinceTheSuccessorWasMade_isRefusedAndLosesNoChange() {
    Counting successor = make(Counting::new);
    assertThat(old.setVariable("LOG LEVEL", "DEBUG")).isTrue();

    assertThat(swap(successor))
        .contains("its configuration was changed during the swap; order the swap again");

    assertThat(old.isRunning()).isTrue();
    assertThat(swap(make(Counting::new))).isEmpty();
  }

  @Test
  void swap_done_takesOverBeforeItBeginsAndTheOldOneIsReleasedInSilence() {
    Counting successor = make(Counting::new);

    assertThat(swap(successor)).isEmpty();

    assertThat(successor.order()).startsWith("takeOver", "begin");
    assertThat(old.order()).endsWith("release");
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
    assertThat(kit.published(Channels.HEALTH))
        .extracting(HealthReport::status)
        .doesNotContain(ServiceStatus.STOPPED);
    assertThat(kit.log("Counting")).noneMatch(line -> line.contains("ERROR"));
  }

  @Test
  void swap_retainedMessageHandledBefore_isHandedToTheNewOneOnce() {
    kit.publish(Channels.GOALS, new GoalList());
    Counting successor = make(Counting::new);

    swap(successor);

    assertThat(successor.order()).containsExactly("takeOver", "begin", "GoalList");
  }

  @Test
  void swap_retainedMessageStillWaiting_isHandedToTheNewOneOnce() {
    kit.publish(Channels.GOALS, new GoalList());
    Counting successor = make(Counting::new);
    kit.send(Channels.GOALS, new GoalList());

    swap(successor);

    assertThat(successor.order()).containsExactly("takeOver", "begin", "GoalList");
  }

  @Test
  void swap_successorSubscribesToMore_getsIt() {
    Counting successor =
        make(
            context -> {
              Counting made = new Counting(context);
              made.registerSubscriber(Channels.GOAL_UPDATES);
              return made;
            });
    swap(successor);

    kit.publish(Channels.GOAL_UPDATES, new Waypoint().horizontalThreshold(1.0).uid("a"));

    assertThat(successor.order()).endsWith("Waypoint");
  }

  @Test
  void swap_done_nameAndHealthGoOnAndDiscoverySaysTheNewClass() {
    Counting successor = make(context -> new Counting(context) {});

    swap(successor);
    kit.advance(1.0);
    kit.publish(Channels.DISCOVERY, new DiscoveryRequest());

    assertThat(successor.getServiceName()).isEqualTo("Counting");
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(kit.published(Channels.DISCOVERY)).isNotEmpty();
  }

  @Test
  void swap_takeOverThrows_oldOneGoesOnWithItsMessages() {
    Counting successor =
        make(
            context ->
                new Counting(
                    context,
                    state -> {
                      throw new IllegalStateException("wants more");
                    }));
    ServiceSwap swap = new ServiceSwap(old, successor, () -> true).order();
    number(1);
    kit.settle();

    assertThat(swap.outcome()).hasValueSatisfying(why -> assertThat(why).contains("wants more"));
    assertThat(old.isRunning()).isTrue();
    assertThat(old.handled).containsExactly("n1");
    assertThat(successor.order()).containsExactly("release");
    assertThat(swap(make(Counting::new))).isEmpty();
  }

  /** Of another role. */
  private static final class Planner extends EventDrivenService {
    Planner(ServiceContext context) {
      super(context, ServiceRole.PATH_PLANNER, "Planner");
    }
  }

  @Test
  void swap_otherRole_isRefused() {
    assertThat(swap(make(Planner::new)))
        .hasValueSatisfying(
            why -> assertThat(why).contains("PATH_PLANNER").contains("expected a OBSERVER"));
    assertThat(old.isRunning()).isTrue();
  }

  @Test
  void swap_twoAtOnce_secondIsRefusedAndTheFirstIsDone() {
    Counting first = make(Counting::new);
    ServiceSwap one = new ServiceSwap(old, first, () -> true).order();
    ServiceSwap two = new ServiceSwap(old, make(Counting::new), () -> true).order();
    kit.settle();

    assertThat(one.outcome()).isEmpty();
    assertThat(two.outcome()).contains("it is already being swapped");
    number(1);
    kit.settle();
    assertThat(first.handled).containsExactly("n1");
  }

  @Test
  void swap_oldOneEndsBefore_isRefused() {
    Counting successor = make(Counting::new);
    ServiceSwap swap = new ServiceSwap(old, successor, () -> true).order();
    old.kill();

    assertThat(swap.outcome()).contains("it ended before");
    assertThat(new ServiceSwap(old, make(Counting::new), () -> true).order().outcome())
        .contains("it is not running (STOPPED)");
  }

  @Test
  void swap_allServicesAreEnding_successorEndsAndReleases() {
    Counting successor = make(Counting::new);
    ServiceSwap swap = new ServiceSwap(old, successor, () -> false).order();
    kit.settle();

    assertThat(swap.isDecided()).isTrue();
    assertThat(successor.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(kit.published(Channels.GOAL_REPORTS)).hasSize(1);
  }

  @Test
  void swap_stopCommandMeanwhile_endsTheSuccessor() throws InterruptedException {
    Counting successor = make(Counting::new);
    old.inHandOver(state -> kit.send(Channels.STOP, new StopCommand().serviceName("Counting")));
    swap(successor);
    successor.join();

    assertThat(successor.status()).isEqualTo(ServiceStatus.STOPPED);
  }

  @Test
  void await_oldOneHangs_orderIsWithdrawn() throws InterruptedException {
    // Nobody drives the clock: the old service's thread gets no turn, as if its callback never
    // returned.
    Counting successor = make(Counting::new);
    ServiceSwap swap = new ServiceSwap(old, successor, () -> true).order();

    assertThat(swap.await(0.05))
        .hasValueSatisfying(why -> assertThat(why).contains("more than 0.05 s"));
    number(1);
    kit.settle();
    assertThat(old.handled).containsExactly("n1");
  }

  /** One that also listens to changes of goals, which the old one does not. */
  private Counting hearingMore() {
    Counting successor = new Counting(inPlaceOf(old));
    successor.registerSubscriber(Channels.GOAL_UPDATES);
    return successor;
  }

  private void update() {
    kit.publish(Channels.GOAL_UPDATES, new Waypoint().horizontalThreshold(1.0).uid("a"));
  }

  private boolean has(String part) {
    return kit.log("Counting").stream().anyMatch(line -> line.contains(part));
  }

  @Test
  void order_successorWithAVariableThatItDoesNotDeclare_isRefused() {
    XmlConfiguration misspelt = old.context().configuration().forSuccessor();
    misspelt.override("LOG LEVLE", "DEBUG");

    ServiceSwap swap = order(new Counting(inPlaceOf(old, misspelt)));

    assertThat(swap.outcome())
        .hasValueSatisfying(
            why -> assertThat(why).contains("\"LOG LEVLE\": no service declares it"));
    assertThat(old.isRunning()).isTrue();
    assertThat(has("not swapped for " + Counting.class.getName())).isTrue();
  }

  @Test
  void order_handOverFails_dropsWhatOnlyTheSuccessorWantedAndLogsTheFault() {
    Counting successor = hearingMore();
    old.inHandOver(
        state -> {
          throw new LinkageError("half a jar");
        });

    assertThat(order(successor).outcome())
        .contains("handing over failed: java.lang.LinkageError: half a jar");
    update();

    assertThat(old.order()).doesNotContain("Waypoint");
    assertThat(has("ERROR")).isTrue();
    assertThat(has("handing over failed")).isTrue();
    assertThat(successor.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(old.isRunning()).isTrue();
  }

  @Test
  void order_done_isLoggedAndTheSuccessorHearsWhatItWantsOnly() {
    Counting successor = hearingMore();

    assertThat(order(successor).outcome()).isEmpty();
    update();

    assertThat(successor.order()).endsWith("Waypoint");
    assertThat(has("handed over to " + Counting.class.getName())).isTrue();
    assertThat(has("not swapped")).isFalse();
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
    Deaf successor = new Deaf(inPlaceOf(old));

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
    Counting successor = new Counting(inPlaceOf(old));
    Launcher launcher =
        kit.start(context -> new Launcher(context, new ServiceSwap(old, successor, () -> true)));

    update();

    assertThat(launcher.outcome).isEmpty();
    assertThat(successor.isRunning()).isTrue();
    successor.kill();
  }
}
