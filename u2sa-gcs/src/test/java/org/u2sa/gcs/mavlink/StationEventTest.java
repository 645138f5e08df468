package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import io.dronefleet.mavlink.common.CurrentEventSequence;
import io.dronefleet.mavlink.common.Event;
import io.dronefleet.mavlink.common.RequestEvent;
import io.dronefleet.mavlink.common.ResponseEventError;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.event.EventMetadata;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** Events as a station receives them, looked up in the metadata as stations do it. */
@SuppressWarnings("deprecation") // the library is older than the messages' final form
class StationEventTest {
  private final BridgeKit kit = BridgeKit.rover().ready();
  private JsonNode described;

  @BeforeEach
  void describe() throws Exception {
    described =
        new ObjectMapper()
            .readTree(EventMetadata.json())
            .at("/components/1/event_groups/default/events");
    kit.advance(0.2);
    kit.received(Event.class);
  }

  private List<String> names() {
    return kit.received(Event.class).stream()
        .map(event -> described.at("/" + (event.id() & 0xFF_FFFF) + "/name").asText())
        .collect(Collectors.toList());
  }

  private Event only() {
    List<Event> events = kit.received(Event.class);
    assertThat(events).hasSize(1);
    return events.get(0);
  }

  private static ByteBuffer arguments(Event event) {
    return ByteBuffer.wrap(event.arguments()).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void arm(boolean armed) {
    kit.says(new ArmingState().armed(armed));
    kit.step();
  }

  private void request(int first, int last) {
    kit.send(
        RequestEvent.builder()
            .targetSystem(1)
            .targetComponent(1)
            .firstSequence(first)
            .lastSequence(last)
            .build());
  }

  @Test
  void armingAndFailsafe_areEventsInOrder() {
    arm(true);
    kit.says(
        new FailsafeState()
            .action(FailsafeAction.RETURN)
            .causes(List.of("low battery: main, voltage 10.9", "operator link: silent")));
    kit.step();
    Event failsafe = kit.received(Event.class).get(1);
    assertThat(failsafe.logLevels()).isEqualTo(2 << 4 | 2);
    assertThat(arguments(failsafe).get()).isEqualTo((byte) FailsafeAction.RETURN.ordinal());
    assertThat(arguments(failsafe).getInt(1)).isEqualTo(1 << 7 | 1);

    kit.says(new FailsafeState().action(FailsafeAction.CONTINUE));
    kit.step();
    arm(false);
    assertThat(names()).containsExactly("failsafe_over", "disarmed");
  }

  @Test
  void armingRefused_alsoToOthers_isAnEventWithItsReasons() {
    kit.says(new ArmCommand().requestId("web").arm(true).operator("ann"));
    kit.says(
        new ArmingState()
            .armed(false)
            .requestId("web")
            .reasons(List.of("geofence: outside", "a jar's own check: no")));
    kit.step();

    assertThat(arguments(only()).getInt()).isEqualTo(1 << 10 | 1 << 15);
  }

  @Test
  void disarmedOnOrder_withReasonsAgainstArming_isNoRefusal() {
    kit.says(new ArmCommand().requestId("web").arm(false).operator("ann"));
    kit.says(new ArmingState().armed(false).requestId("web").reasons(List.of("mission: no goals")));
    kit.step();
    assertThat(names()).isEmpty();
  }

  @Test
  void goalCompleted_isAnEventWithItsNumberAndTheLastEndsTheMission() {
    Waypoint done = BridgeKit.waypoint("2", 0.001, 0.001).completed(true);
    kit.says(new GoalList());
    kit.says(
        new MissionReport()
            .requestId("r")
            .serviceName("MissionManager")
            .mission("file.xml")
            .goals(List.of(BridgeKit.waypoint("1", 0.001, 0.0), done))
            .finished(List.of(0.0, 1.0))
            .sequence(List.of("1", "2")));
    kit.step();

    List<Event> events = kit.received(Event.class);
    assertThat(arguments(events.get(0)).getShort()).isEqualTo((short) 1); // the second
    assertThat(events.get(1).sequence()).isEqualTo(events.get(0).sequence() + 1);
    assertThat(described.at("/" + (events.get(1).id() & 0xFF) + "/name").asText())
        .isEqualTo("mission_over");
  }

  @Test
  void request_ofMissedEvents_sendsThemAgainAsTheyWere() {
    arm(true);
    arm(false);
    List<Event> sent = kit.received(Event.class);

    request(sent.get(0).sequence(), sent.get(1).sequence());

    assertThat(kit.received(Event.class)).isEqualTo(sent);
  }

  @Test
  void request_ofForgottenOrFutureEvents_isAnErrorWithTheOldest() {
    for (int i = 0; i < 40; i++) {
      arm(true);
      arm(false);
    }
    kit.received(CurrentEventSequence.class);
    kit.advance(1.1);
    int newest = kit.received(CurrentEventSequence.class).get(0).sequence();
    assertThat(newest).isEqualTo(80);
    kit.received(Event.class);

    request(1, 0xFFFF);

    ResponseEventError error = kit.received(ResponseEventError.class).get(0);
    assertThat(error.sequence()).isEqualTo(1);
    assertThat(error.sequenceOldestAvailable()).isEqualTo(newest - 63);
    request(newest - 63, 5); // round the whole circle: what there is, then an error
    assertThat(kit.received(Event.class)).hasSize(64);
    request(newest + 1, newest + 1);
    assertThat(kit.received(ResponseEventError.class)).hasSize(1);
  }

  @Test
  void sequence_afterTheStart_saysThatItBeganAnewAndThenNoLonger() {
    assertThat(kit.received(CurrentEventSequence.class).get(0).flags().value()).isEqualTo(1);
    kit.advance(4.0);
    kit.received(CurrentEventSequence.class);
    kit.advance(1.1);
    assertThat(kit.received(CurrentEventSequence.class).get(0).flags().value()).isZero();
  }
}
