package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.Mosquitto;
import org.u2sa.testkit.NeedsProgram;

/** Two vehicles on one broker: neither hears the other unless it asks to. */
@Timeout(120)
class TwoVehiclesTest {
  private static final Duration SOON = Duration.ofSeconds(30);

  private int port = FreePort.find();

  private static final class Ears implements Receiver {
    private final List<U2SAData> heard = new CopyOnWriteArrayList<>();

    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      heard.add(message);
    }

    @Override
    public void trouble(String what) {
      throw new IllegalStateException(what);
    }
  }

  private CommunicationManager vehicle(String systemId, String broker) {
    return CommunicationManager.start(
        systemId,
        XmlConfiguration.inMemory(
            "test", Map.of("BROKER", broker, "COMMUNICATION MANAGER PORT", port)),
        StandardTypes.registry(),
        line -> {});
  }

  private static PercentageCommand command(String systemId, String actuator) {
    PercentageCommand command = PercentageCommand.of(actuator, 1.0);
    command.systemId(systemId);
    command.timestamp(1);
    command.freeze();
    return command;
  }

  private static void hears(Connection from, Ears to, U2SAData message) {
    await()
        .atMost(SOON)
        .until(
            () -> {
              from.publish(Channels.ACTUATION, message);
              return to.heard.contains(message);
            });
  }

  /** Cessna and boat, whose services have the same name. */
  private static void apartUnlessAsked(CommunicationManager cessna, CommunicationManager boat) {
    Ears inCessna = new Ears();
    Ears inBoat = new Ears();
    Ears curious = new Ears();
    Ears omniscient = new Ears();
    try (Connection ofCessna = cessna.transport().connect("Control", inCessna);
        Connection ofBoat = boat.transport().connect("Control", inBoat);
        Connection asking = cessna.transportOf("boat").connect("Lookout", curious);
        Connection all = boat.transportOf(Topic.ANY_SYSTEM).connect("Recorder", omniscient)) {
      for (Connection each : List.of(ofCessna, ofBoat, asking, all)) {
        assertThat(each.subscribe(Channels.ACTUATION)).isTrue();
        assertThat(each.subscribe(Channels.STOP)).isTrue();
      }
      StopCommand stop = new StopCommand();
      stop.systemId("boat");
      stop.timestamp(2);
      stop.freeze();

      ofBoat.publish(Channels.STOP, stop);
      hears(ofBoat, inBoat, command("boat", "RUDDER"));
      hears(ofCessna, inCessna, command("cessna", "RUDDER"));
      hears(ofBoat, curious, command("boat", "RUDDER"));
      hears(ofBoat, omniscient, command("boat", "RUDDER"));
      hears(ofCessna, omniscient, command("cessna", "RUDDER"));
      hears(asking, inBoat, command("boat", "LIGHT")); // who may hear may also speak
      hears(ofCessna, inCessna, command("cessna", "FLAPS"));

      assertThat(inCessna.heard).allMatch(message -> message.systemId().equals("cessna"));
      assertThat(inBoat.heard).allMatch(message -> message.systemId().equals("boat"));
      assertThat(curious.heard).allMatch(message -> message.systemId().equals("boat"));
      int before = inBoat.heard.size();
      hears(all, inCessna, command("cessna", "ELEVATOR")); // and who hears all, to each by its name
      assertThat(inBoat.heard).hasSize(before);
      PercentageCommand toNobody = PercentageCommand.of("RUDDER", 1.0);
      toNobody.timestamp(1);
      toNobody.freeze();
      assertThat(all.publish(Channels.ACTUATION, toNobody)).isFalse();
    }
  }

  @Test
  void embeddedBrokerOfOne_areApartUnlessAsked() {
    try (CommunicationManager cessna = vehicle("cessna", "embedded");
        CommunicationManager boat = vehicle("boat", "external")) {
      apartUnlessAsked(cessna, boat);
    }
  }

  @Test
  @NeedsProgram("mosquitto")
  void mosquitto_areApartUnlessAsked() throws IOException {
    try (Mosquitto mosquitto = Mosquitto.start(port)) {
      port = mosquitto.port();
      try (CommunicationManager cessna = vehicle("cessna", "external");
          CommunicationManager boat = vehicle("boat", "external")) {
        apartUnlessAsked(cessna, boat);
      }
    }
  }
}
