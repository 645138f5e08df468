package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.StopCommand;
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
}
