package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.Circle;
import org.u2sa.service.inbox.ServiceInbox.Outcome;

/** Which queue of an inbox is full when, what is replaced, and what moves to a successor. */
class ServiceInboxTest {
  private static final int CAPACITY = 8;

  private final LockstepClock clock = new LockstepClock();
  private final ServiceInbox inbox = new ServiceInbox(CAPACITY, clock);

  private static boolean put(ServiceInbox inbox, Channel<?> channel, U2SAData message) {
    return inbox.put(channel, message, 0L) == Outcome.KEPT;
  }

  private static boolean putNumber(ServiceInbox inbox, String number) {
    return put(inbox, Channels.GOAL_COMMANDS, new GoalCommand().uid(number));
  }

  private static int fill(ServiceInbox inbox, Channel<?> channel, U2SAData message) {
    int taken = 0;
    while (taken < 100 && put(inbox, channel, message)) {
      taken++;
    }
    return taken;
  }

  private static StateInformation state(String sensor) {
    return new StateInformation().sensorName(sensor);
  }

  private static List<String> contents(ServiceInbox inbox) {
    List<String> contents = new ArrayList<>();
    for (ServiceInbox.Delivery next = inbox.poll(); next != null; next = inbox.poll()) {
      U2SAData message = next.message();
      contents.add(
          message instanceof GoalCommand command
              ? command.uid()
              : message instanceof StateInformation state
                  ? state.sensorName()
                  : message.type().name());
    }
    return contents;
  }

  @Test
  void put_eachQueueAlone_holdsExactlyTheCapacity() {
    assertThat(fill(inbox, Channels.GOAL_COMMANDS, new GoalCommand())).isEqualTo(CAPACITY);
    assertThat(fill(inbox, Channels.ARMING, new ArmCommand())).isEqualTo(CAPACITY);
    assertThat(fill(inbox, Channels.EMERGENCY_STOP, new EmergencyStop())).isEqualTo(CAPACITY);

    assertThat(inbox.depth()).isEqualTo(3 * CAPACITY);
    assertThat(inbox.dropped()).isEqualTo(3);
  }

  /** A message of many bytes from another process. */
  private static U2SAData received(String sensor, int bytes) throws MalformedMessageException {
    U2SAData message =
        new CameraImage()
            .sensorName(sensor)
            .format("jpeg")
            .data(ByteString.copyOf(new byte[bytes]));
    return new MessageCodec(StandardTypes.registry())
        .decode(message.typeChain(), message.serialize());
  }

  private static final int LONG = 800_000;

  @Test
  void put_longMessagesOfManySources_takesSomeMegabytesOnly() throws MalformedMessageException {
    ServiceInbox large = new ServiceInbox(1_000, clock);
    int kept = 0;
    while (kept < 1_000 && put(large, Channels.IMAGES, received("camera " + kept, LONG))) {
      kept++;
    }

    assertThat((long) kept * LONG)
        .isLessThanOrEqualTo(Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 64));
    assertThat(kept).isGreaterThan(2);
    assertThat(put(large, Channels.ARMING, new ArmCommand())).isTrue();
    assertThat(put(large, Channels.EMERGENCY_STOP, new EmergencyStop())).isTrue();
    large.poll();
    large.poll();
    assertThat(put(large, Channels.IMAGES, received("another", LONG))).isTrue();
    assertThat(put(large, Channels.IMAGES, received("one more", LONG))).isFalse();
  }

  @Test
  void put_messageLongerThanAllMayBe_fitsAlone() throws MalformedMessageException {
    ServiceInbox small = new ServiceInbox(1_000, clock, 1_000);
    assertThat(put(small, Channels.IMAGES, received("first", 2_000))).isTrue();
    assertThat(put(small, Channels.IMAGES, received("second", 10))).isFalse();

    small.poll();

    assertThat(put(small, Channels.IMAGES, received("second", 2_000))).isTrue();
  }

  @Test
  void put_shortMessagesReplacedByLongOnes_countTheirBytesToo() throws MalformedMessageException {
    ServiceInbox large = new ServiceInbox(1_000, clock);
    for (int i = 0; i < 400; i++) {
      put(large, Channels.IMAGES, received("camera " + i, 10));
    }
    int replaced = 0;
    while (replaced < 400 && put(large, Channels.IMAGES, received("camera " + replaced, LONG))) {
      replaced++;
    }

    assertThat(replaced).isBetween(3, 399);
    assertThat(large.depth()).isEqualTo(400);
  }

  @Test
  void put_afterAReservedOneWasTaken_makesRoomForOneReservedOne() {
    fill(inbox, Channels.ARMING, new ArmCommand());
    inbox.poll();

    assertThat(fill(inbox, Channels.ARMING, new ArmCommand())).isOne();
    assertThat(fill(inbox, Channels.GOAL_COMMANDS, new GoalCommand())).isEqualTo(CAPACITY);
  }

  @Test
  void put_questionIntoASmallInbox_hasRoomForOne() {
    ServiceInbox small = new ServiceInbox(3, clock);

    assertThat(fill(small, Channels.FUNCTIONALITY, new FunctionalityRequest())).isOne();
    assertThat(fill(small, Channels.GOAL_COMMANDS, new GoalCommand())).isEqualTo(2);
  }

  @Test
  void put_newerOfOneSource_replacesMessageAndTimeButNotItsPlace() {
    inbox.put(Channels.STATE, state("A"), 1L);
    inbox.put(Channels.STATE, state("B"), 2L);
    StateInformation newer = state("A");
    assertThat(inbox.put(Channels.STATE, newer, 3L)).isEqualTo(Outcome.KEPT);

    assertThat(inbox.replaced()).isOne();
    ServiceInbox.Delivery first = inbox.poll();
    assertThat(first.message()).isSameAs(newer);
    assertThat(first.arrivedMicros()).isEqualTo(3L);
    assertThat(first.channel() == (Channel<?>) Channels.STATE).isTrue();
    assertThat(contents(inbox)).containsExactly("B");
  }

  @Test
  void put_latestIntoAFullInbox_isLostAndNotTakenForOneThatWaits() {
    fill(inbox, Channels.GOAL_COMMANDS, new GoalCommand());
    assertThat(put(inbox, Channels.STATE, state("A"))).isFalse();
    assertThat(put(inbox, Channels.STATE, state("A"))).isFalse();
    assertThat(inbox.dropped()).as("with the one that did not fit").isEqualTo(3);
    assertThat(inbox.replaced()).isZero();

    inbox.poll();

    assertThat(put(inbox, Channels.STATE, state("A"))).isTrue();
    assertThat(inbox.depth()).isEqualTo(CAPACITY);
  }

  @Test
  void moveTo_allThatWaits_comesAheadOfWhatIsThereAndUrgentFirst() {
    ServiceInbox next = new ServiceInbox(CAPACITY, clock);
    putNumber(inbox, "old 1");
    put(inbox, Channels.EMERGENCY_STOP, new EmergencyStop());
    putNumber(next, "new 1");
    put(next, Channels.STATE, state("new state"));

    inbox.moveTo(next, List.of());
    assertThat(putNumber(inbox, "put into the old one")).isTrue();

    assertThat(inbox.depth()).isZero();
    assertThat(inbox.poll()).isNull();
    assertThat(contents(next))
        .containsExactly("EmergencyStop", "old 1", "new 1", "new state", "put into the old one");
  }

  @Test
  void moveTo_urgentOneWaitsInTheSuccessorAlready_isThereOnceBehindTheOthers() {
    ServiceInbox next = new ServiceInbox(CAPACITY, clock);
    EmergencyStop before = new EmergencyStop();
    EmergencyStop after = new EmergencyStop();
    put(inbox, Channels.EMERGENCY_STOP, before);
    put(next, Channels.EMERGENCY_STOP, after);

    inbox.moveTo(next, List.of());

    assertThat(next.depth()).isEqualTo(2);
    assertThat(next.poll().message()).isSameAs(before);
    assertThat(next.poll().message()).isSameAs(after);
  }

  @Test
  void put_afterTheMoveToAFullSuccessor_isLostThere() {
    ServiceInbox next = new ServiceInbox(1, clock);
    inbox.moveTo(next, List.of());

    assertThat(putNumber(inbox, "1")).isTrue();
    assertThat(putNumber(inbox, "2")).isFalse();
    assertThat(next.dropped()).isOne();
  }

  @Test
  void moveTo_handledBefore_isSeenFirstUnlessANewerOneWaits() {
    ServiceInbox next = new ServiceInbox(CAPACITY, clock);
    put(inbox, Channels.STATE, state("A"));
    put(inbox, Channels.STATE, state("B"));
    List<ServiceInbox.Delivery> handled = List.of(inbox.poll(), inbox.poll());
    put(inbox, Channels.STATE, state("B"));
    putNumber(inbox, "waits");

    inbox.moveTo(next, handled);

    assertThat(contents(next)).containsExactly("A", "B", "waits");
  }

  @Test
  void moveTo_latestThatWaits_isReplacedInItsNewPlace() {
    ServiceInbox next = new ServiceInbox(CAPACITY, clock);
    put(inbox, Channels.STATE, state("A"));
    inbox.moveTo(next, List.of());

    put(next, Channels.STATE, state("A"));

    assertThat(next.depth()).isOne();
    assertThat(next.replaced()).isOne();
  }

  @Test
  void moveTo_lostAndReplacedSoFar_areSummed() {
    ServiceInbox next = new ServiceInbox(1, clock);
    fill(inbox, Channels.GOAL_COMMANDS, new GoalCommand());
    put(inbox, Channels.ARMING_STATE, new ArmingState());
    put(inbox, Channels.ARMING_STATE, new ArmingState());
    fill(next, Channels.GOAL_COMMANDS, new GoalCommand());
    put(next, Channels.ARMING_STATE, new ArmingState());
    put(next, Channels.ARMING_STATE, new ArmingState());

    inbox.moveTo(next, List.of());

    assertThat(next.dropped()).isEqualTo(2);
    assertThat(next.replaced()).isEqualTo(2);
  }

  @Test
  void moveTo_questionsAndReservedOnesOfBoth_countInTheSuccessor() {
    ServiceInbox next = new ServiceInbox(CAPACITY, clock);
    put(inbox, Channels.DISCOVERY, new DiscoveryRequest());
    put(next, Channels.DISCOVERY, new DiscoveryRequest());
    put(inbox, Channels.ARMING, new ArmCommand());
    put(next, Channels.ARMING, new ArmCommand());

    inbox.moveTo(next, List.of());

    assertThat(put(next, Channels.DISCOVERY, new DiscoveryRequest())).isFalse();
    assertThat(fill(next, Channels.ARMING, new ArmCommand())).isEqualTo(CAPACITY - 2);
    assertThat(fill(next, Channels.GOAL_COMMANDS, new GoalCommand())).isEqualTo(CAPACITY - 2);
  }

  @Test
  void put_moreSourcesThanAnyVehicleHas_keepsToTheFirst() {
    for (int i = 0; i < ServiceInbox.MAX_SOURCES; i++) {
      assertThat(put(inbox, Channels.SENSED_STATE, state("s" + i))).isTrue();
      inbox.poll();
    }

    assertThat(inbox.put(Channels.SENSED_STATE, state("invented"), 0L))
        .isEqualTo(Outcome.UNKNOWN_SOURCE);
    assertThat(put(inbox, Channels.SENSED_STATE, state("s0"))).isTrue();
    assertThat(put(inbox, Channels.STATE, state("invented"))).isTrue(); // counted by channel
    assertThat(contents(inbox)).containsExactly("s0", "invented");
    assertThat(inbox.dropped()).isEqualTo(1);
  }

  @Test
  void put_moreSourcesOfObjectsThanAnyVehicleHas_keepsToTheFirst() {
    for (int i = 0; i < ServiceInbox.MAX_SOURCES; i++) {
      assertThat(put(inbox, Channels.SENSED_OBJECTS, new Circle().sensorName("s" + i))).isTrue();
      inbox.poll();
    }

    assertThat(inbox.put(Channels.SENSED_OBJECTS, new Circle().sensorName("invented"), 0L))
        .isEqualTo(Outcome.UNKNOWN_SOURCE);
    assertThat(put(inbox, Channels.SENSED_OBJECTS, new Circle().sensorName("s0"))).isTrue();
    assertThat(put(inbox, Channels.SENSED_OBJECTS, new Circle())).isTrue(); // names no source
  }

  private static final long SILENT_MICROS = 60_000_000;

  private boolean hears(String sensor) {
    boolean kept = put(inbox, Channels.SENSED_STATE, state(sensor));
    inbox.poll();
    return kept;
  }

  private void fillSources() {
    for (int i = 0; i < ServiceInbox.MAX_SOURCES; i++) {
      assertThat(hears("s" + i)).isTrue();
    }
  }

  @Test
  void put_newSourceWhileAllOthersSpeak_findsNoRoomHoweverLong() throws InterruptedException {
    fillSources();
    for (int minute = 0; minute < 5; minute++) {
      clock.advance(SILENT_MICROS);
      assertThat(hears("new")).isFalse();
      for (int i = 0; i < ServiceInbox.MAX_SOURCES; i++) {
        assertThat(hears("s" + i)).isTrue();
      }
    }
  }

  @Test
  void put_newSourceAfterOneFellSilent_takesItsRoomAndNobodyElses() throws InterruptedException {
    fillSources();
    assertThat(hears("new")).isFalse();
    for (int half = 0; half < 4; half++) {
      clock.advance(SILENT_MICROS / 2);
      for (int i = 1; i < ServiceInbox.MAX_SOURCES; i++) {
        assertThat(hears("s" + i)).isTrue();
      }
      assertThat(hears("new")).as("after %s half minutes", half + 1).isEqualTo(half == 3);
    }

    assertThat(hears("another")).isFalse();
    assertThat(hears("s0")).as("the one that was silent").isFalse();
    assertThat(hears("s1")).isTrue();
    assertThat(hears("new")).isTrue();
  }

  @Test
  void put_silentSourceWhoseMessageStillWaits_keepsItsRoom() throws InterruptedException {
    ServiceInbox roomy = new ServiceInbox(1_000, clock);
    for (int i = 0; i < ServiceInbox.MAX_SOURCES; i++) {
      assertThat(put(roomy, Channels.SENSED_STATE, state("s" + i))).isTrue();
    }
    for (int minute = 0; minute < 4; minute++) {
      clock.advance(SILENT_MICROS);
      assertThat(put(roomy, Channels.SENSED_STATE, state("new"))).isFalse();
    }
    assertThat(contents(roomy)).hasSize(ServiceInbox.MAX_SOURCES).startsWith("s0");
  }

  @Test
  void put_longMessagesOfManySourcesOneAfterAnother_areTakenUpToSomeMegabytes()
      throws MalformedMessageException {
    ServiceInbox large = new ServiceInbox(1_000, clock);
    long most = Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 32);
    int kept = 0;
    while (kept < 500
        && put(large, Channels.IMAGES, received("camera " + kept, kept == 0 ? 700_000 : LONG))) {
      large.poll();
      kept++;
    }
    assertThat((long) kept * (1 << 20)).isBetween(most - (1 << 20), most);
    assertThat(large.put(Channels.IMAGES, received("one more", LONG), 0L))
        .isEqualTo(Outcome.TOO_LONG);

    assertThat(put(large, Channels.IMAGES, received("camera 0", LONG)))
        .as("somewhat longer than before")
        .isTrue();
    assertThat(put(large, Channels.IMAGES, received("short", 1_000))).isTrue();
    assertThat(put(large, Channels.SENSED_STATE, state("another channel"))).isTrue();
  }

  @Test
  void put_longMessageOfANewSourceAfterOthersFellSilent_isTaken()
      throws InterruptedException, MalformedMessageException {
    ServiceInbox large = new ServiceInbox(1_000, clock);
    int kept = 0;
    while (put(large, Channels.IMAGES, received("camera " + kept, LONG))) {
      large.poll();
      kept++;
    }
    for (int minute = 0; minute < 3; minute++) {
      clock.advance(SILENT_MICROS);
      large.put(Channels.IMAGES, received("new", LONG), 0L);
    }
    assertThat(put(large, Channels.IMAGES, received("new", LONG))).isTrue();
  }

  @Test
  void put_floodOfQuestions_fillsAQuarterAndLeavesRoomForTheRest() {
    assertThat(fill(inbox, Channels.CONFIGURATION, new ConfigurationRequest()))
        .isEqualTo(CAPACITY / 4);

    assertThat(put(inbox, Channels.DISCOVERY, new DiscoveryRequest())).isFalse();
    assertThat(put(inbox, Channels.CONFIGURATION, new ConfigurationChange())).isTrue();
    assertThat(put(inbox, Channels.GOALS, new GoalList())).isTrue();
    assertThat(inbox.dropped()).isEqualTo(2);
  }

  @Test
  void poll_questionTaken_makesRoomForTheNext() {
    fill(inbox, Channels.CONFIGURATION, new ConfigurationRequest());
    inbox.poll();

    assertThat(put(inbox, Channels.DISCOVERY, new DiscoveryRequest())).isTrue();
    assertThat(put(inbox, Channels.DISCOVERY, new DiscoveryRequest())).isFalse();
  }

  @Test
  void put_safetysMessagesIntoAFullInbox_areTaken() {
    fill(inbox, Channels.CONFIGURATION, new ConfigurationChange());
    assertThat(put(inbox, Channels.CONFIGURATION, new ConfigurationChange())).isFalse();

    ArmCommand arm = new ArmCommand();
    EmergencyStop stop = new EmergencyStop();
    assertThat(put(inbox, Channels.ARMING, arm)).isTrue();
    assertThat(put(inbox, Channels.EMERGENCY_STOP, stop)).isTrue();
    assertThat(put(inbox, Channels.FAILSAFE, new FailsafeState())).isTrue();
    assertThat(put(inbox, Channels.ARMING_STATE, new ArmingState())).isTrue();

    assertThat(inbox.poll().message()).isSameAs(stop);
    for (int i = 0; i < CAPACITY; i++) {
      assertThat(inbox.poll().message()).isInstanceOf(ConfigurationChange.class);
    }
    assertThat(inbox.poll().message()).as("in its turn").isSameAs(arm);
    assertThat(inbox.depth()).isEqualTo(2);
  }
}
