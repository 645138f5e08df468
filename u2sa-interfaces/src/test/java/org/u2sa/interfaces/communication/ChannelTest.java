package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/** What a channel promises of delivery, and which standard ones there are. */
class ChannelTest {
  private static final Channel<StateInformation> LATEST =
      Channel.latest("depth", StateInformation.TYPE, StateInformation::sensorName);
  private static final Channel<StateInformation> EVERY =
      Channel.every("depths", StateInformation.TYPE);

  /** Every, retained, by source, urgent, with room of its own. */
  private static String promises(Channel<?> channel) {
    return (channel.deliversEvery() ? "every " : "latest ")
        + (channel.isRetained() ? "retained " : "")
        + (channel.isRetainedBySource() ? "bySource " : "")
        + (channel.isUrgent() ? "urgent " : "")
        + (channel.reservesRoom() ? "room" : "");
  }

  @Test
  void channel_asMade_promisesNothingMore() {
    assertThat(promises(EVERY)).isEqualTo("every ");
    assertThat(promises(LATEST)).isEqualTo("latest ");
  }

  @Test
  void channel_eachPromiseAdded_keepsTheOthers() {
    assertThat(promises(EVERY.retained())).isEqualTo("every retained ");
    assertThat(promises(LATEST.retainedBySource())).isEqualTo("latest retained bySource ");
    assertThat(promises(EVERY.urgent())).isEqualTo("every urgent room");
    assertThat(promises(LATEST.reservingRoom())).isEqualTo("latest room");
    assertThat(promises(LATEST.retainedBySource().reservingRoom().urgent().retained()))
        .isEqualTo("latest retained bySource urgent room");
    assertThat(promises(LATEST.urgent().retainedBySource().carrying(StateInformation.TYPE)))
        .isEqualTo("latest retained bySource urgent room");
  }

  @Test
  void sourceOf_messageOfItsType_isWhatTheChannelWasMadeWith() {
    StateInformation state = new StateInformation().sensorName("SONAR");

    assertThat(LATEST.sourceOf(state)).isEqualTo("SONAR");
    assertThat(LATEST.retained().urgent().sourceOf(state)).isEqualTo("SONAR");
    assertThat(EVERY.sourceOf(state)).isEmpty();
    assertThat(LATEST.sourceOf(new StopCommand())).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "Depth", "1depth", "-depth", "depth-", "a--b", "a b", "a/b", "tiefeß"})
  void every_nameOfAnotherForm_isRefused(String name) {
    assertThatThrownBy(() -> Channel.every(name, StateInformation.TYPE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "channel \""
                + name
                + "\": expected lower-case words joined by hyphens, such as \"goal-reports\"");
    assertThatThrownBy(() -> Channel.latest(name, StateInformation.TYPE, state -> ""))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a", "a1", "goal-reports", "x-2-y"})
  void every_nameOfTheForm_isTheName(String name) {
    assertThat(Channel.every(name, StateInformation.TYPE)).hasToString(name);
    assertThat(Channel.latest(name, StateInformation.TYPE, state -> "").name()).isEqualTo(name);
  }

  @Test
  void equals_sameName_whateverTheRest() {
    Channel<GoalList> other = Channel.every("depth", GoalList.TYPE);

    assertThat(LATEST).isEqualTo(other).hasSameHashCodeAs(other).isNotEqualTo(EVERY);
    assertThat(LATEST.equals((Object) "depth")).isFalse();
    assertThat(LATEST.hashCode()).isNotEqualTo(EVERY.hashCode());
  }

  @Test
  void carriedTypes_ofEachKind_areThoseNamedOrTheTypeItself() {
    assertThat(EVERY.carriedTypes()).hasToString("[" + StateInformation.TYPE + "]");
    assertThat(Channels.DISCOVERY.carriedTypes()).hasSize(2);
    assertThat(Channel.every("own", U2SAData.TYPE).carriedTypes())
        .hasToString("[" + U2SAData.TYPE + "]");
  }

  @Test
  void carries_typeOfAnotherBranch_isNotCarried() {
    assertThat(EVERY.carries(StateInformation.TYPE)).isTrue();
    assertThat(EVERY.carries(GoalList.TYPE)).isFalse();
    assertThat(EVERY.carries(U2SAData.TYPE)).isFalse();
    assertThat(Channel.every("own", U2SAData.TYPE).carries(EmergencyStop.TYPE)).isFalse();
  }

  @Test
  void named_eachStandardChannel_isThatOne() {
    for (Channel<?> channel : Channels.all()) {
      assertThat(Channels.named(channel.name()).orElseThrow() == channel).isTrue();
      assertThat(Channels.namedOrNew(channel.name()) == channel).isTrue();
    }
    assertThat(Channels.named("tide")).isEmpty();
  }

  @Test
  void namedOrNew_noStandardName_isAChannelOfAnyMessage() {
    Channel<?> own = Channels.namedOrNew("tide");

    assertThat(own.name()).isEqualTo("tide");
    assertThat(own.deliversEvery()).isTrue();
    assertThat(own.carries(StateInformation.TYPE)).isTrue();
  }

  private static final Channel<U2SAData> ANYTHING = Channel.every("my-own", U2SAData.TYPE);

  @Test
  void carries_standardChannels_eachTypeOfTheContractTravelsOnOneOnly() {
    List<MessageType<?>> parts = List.of(ConfigurationVariable.TYPE, ConfigurationAssignment.TYPE);
    List<String> wrong = new ArrayList<>();
    for (MessageType<?> type : StandardTypes.registry().all()) {
      long channels = Channels.all().stream().filter(channel -> channel.carries(type)).count();
      if (Channel.CarriedTypes.isOfContract(type) && channels != (parts.contains(type) ? 0 : 1)) {
        wrong.add(type + " on " + channels);
      }
    }
    assertThat(wrong).isEmpty();
  }

  @Test
  void carries_channelOfAnyMessage_excludesTheContract() throws MalformedMessageException {
    assertThat(ANYTHING.carries(new StateInformation())).isTrue();
    assertThat(ANYTHING.carries(unknown("Tide"))).isTrue();
    assertThat(ANYTHING.carries(new EmergencyStop())).isFalse();
    assertThat(ANYTHING.carries(unknown("StopCommand", "Tide"))).isFalse();
  }

  @Test
  void carries_contractsChannel_takesItsOwnTypesAndTheirSubclassesOnly()
      throws MalformedMessageException {
    assertThat(Channels.DISCOVERY.carries(new DiscoveryRequest())).isTrue();
    assertThat(Channels.DISCOVERY.carries(unknown("DiscoveryRequest", "Tide"))).isTrue();
    assertThat(Channels.DISCOVERY.carries(new StopCommand())).isFalse();
    assertThat(Channels.CONFIGURATION.carries(new EmergencyStop())).isFalse();
    assertThat(Channels.DISCOVERY.carries(unknown("Tide"))).isFalse();
  }

  @Test
  void publish_typeThatTheChannelDoesNotCarry_reachesNobody() {
    List<U2SAData> received = new ArrayList<>();
    LocalBus bus = new LocalBus("cessna");
    Connection connection = bus.connect("A", receiver(received));
    connection.subscribe(Channels.DISCOVERY);
    connection.subscribe(ANYTHING);

    assertThat(connection.publish(Channels.DISCOVERY, new StopCommand())).isFalse();
    bus.deliver(Channels.DISCOVERY, new StopCommand());
    bus.deliver(ANYTHING, new StopCommand());

    assertThat(received).isEmpty();
  }

  private static U2SAData unknown(String... chain) throws MalformedMessageException {
    byte[] empty = {(byte) 0xa0}; // CBOR: a map without entries
    return new MessageCodec(StandardTypes.registry()).decode(List.of(chain), empty);
  }

  private static Receiver receiver(List<U2SAData> received) {
    return new Receiver() {
      @Override
      public void receive(Channel<?> channel, U2SAData message) {
        received.add(message);
      }

      @Override
      public void trouble(String what) {
        throw new AssertionError(what);
      }
    };
  }
}
