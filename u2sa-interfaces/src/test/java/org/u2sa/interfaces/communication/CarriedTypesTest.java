package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/** Which types travel on which channels. */
class CarriedTypesTest {
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
