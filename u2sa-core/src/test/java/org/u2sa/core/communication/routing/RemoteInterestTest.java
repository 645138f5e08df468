package org.u2sa.core.communication.routing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.mqtt.OriginNumbers;

/** Where copies of messages go, and whether anybody wants them. */
class RemoteInterestTest {
  private static final List<String> STATE = List.of("StateInformation");
  private static final List<String> AIRCRAFT = List.of("StateInformation", "AircraftState");

  private final RemoteSubscriptions subscriptions =
      new RemoteSubscriptions((topic, filter) -> topic.match(filter));
  private final RemoteInterest interest =
      new RemoteInterest("cessna", subscriptions, OriginNumbers.ofNewSender());

  private RemoteInterest.Destination ofState(List<String> typeChain) {
    return interest.destination(Channels.STATE, typeChain);
  }

  @Test
  void destination_sameTypeByAnotherList_isTheSame() {
    RemoteInterest.Destination first = ofState(STATE);

    assertThat(ofState(new ArrayList<>(STATE))).isSameAs(first);
    assertThat(first.topic()).isEqualTo("u2sa/cessna/state/StateInformation");
  }

  @Test
  void destination_subclassOrOtherChannel_isAnother() {
    RemoteInterest.Destination first = ofState(STATE);
    RemoteInterest.Destination subclass = ofState(AIRCRAFT);
    RemoteInterest.Destination elsewhere = interest.destination(Channels.LOCAL_STATE, STATE);

    assertThat(subclass.topic()).isEqualTo("u2sa/cessna/state/StateInformation/AircraftState");
    assertThat(elsewhere.topic()).isEqualTo("u2sa/cessna/local-state/StateInformation");
    assertThat(first.stream()).isNotSameAs(subclass.stream()).isNotSameAs(elsewhere.stream());
  }

  @Test
  void isWanted_subscribersComeAndGo_followsThem() {
    RemoteInterest.Destination state = ofState(STATE);
    assertThat(state.isWanted()).isFalse();
    subscriptions.add("1", "screen", "u2sa/cessna/state/#", false);
    assertThat(state.isWanted()).isTrue();
    assertThat(ofState(AIRCRAFT).isWanted()).isTrue();
    subscriptions.remove("1");

    assertThat(state.isWanted()).isFalse();
  }
}
