package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.communication.discovery.BrokerSearch;
import org.u2sa.core.communication.discovery.FoundBroker;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.testkit.FreePort;

/** Brokers that are found by multicast DNS, on loopback: no word of these leaves the host. */
@Timeout(180)
class BrokerSearchTest {
  private static final MessageTypes TYPES = StandardTypes.registry();
  private static final double LONG_S = 60.0; // ends as soon as one is found

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final String system = "boat-" + UUID.randomUUID(); // others may announce theirs meanwhile

  private CommunicationManager manager(String systemId, Map<String, Object> variables) {
    Map<String, Object> all = new HashMap<>(variables);
    if (!all.containsKey("BROKER")) {
      all.put("COMMUNICATION MANAGER PORT", FreePort.find());
    }
    return CommunicationManager.start(
        systemId, XmlConfiguration.inMemory("test", all), TYPES, log::add);
  }

  private CommunicationManager announced() {
    return manager(system, Map.of("ANNOUNCE", "yes"));
  }

  private FoundBroker search(double timeoutS) throws InterruptedException {
    return BrokerSearch.theOnly(Optional.of(system), new SystemClock(), timeoutS);
  }

  @Test
  void theOnly_oneAnnouncedAndOneOnLoopbackUnasked_isFoundWhereItListens() throws Exception {
    try (CommunicationManager silent = manager(system, Map.of());
        CommunicationManager manager = announced()) {
      FoundBroker found = search(LONG_S);

      assertThat(silent.address()).isPresent();
      assertThat(found.port()).isEqualTo(manager.address().orElseThrow().getPort());
      assertThat(found.host()).isEqualTo("127.0.0.1");
      assertThat(found.systems()).containsExactly(system);
      assertThat(found.encrypted()).isFalse();
    }
  }

  @Test
  void start_externalAtAuto_servicesOfBothProcessesHearEachOther() throws Exception {
    try (CommunicationManager manager = announced();
        CommunicationManager other =
            manager(
                system,
                Map.of(
                    "BROKER",
                    "external",
                    "COMMUNICATION MANAGER IP",
                    "auto",
                    "COMMUNICATION MANAGER WAIT",
                    LONG_S))) {
      RecordingReceiver inbox = new RecordingReceiver();
      try (Connection here = manager.transport().connect("Here", new RecordingReceiver());
          Connection there = other.transport().connect("There", inbox)) {
        assertThat(there.subscribe(Channels.ACTUATION)).isTrue();
        BrokerTraffic.publishUntilReceived(here, inbox, BrokerTraffic.command(1.0));
      }
      assertThat(log).anyMatch(line -> line.contains("found by mDNS"));
    }
  }

  @Test
  void theOnly_severalOfOneSystem_listsThem() throws Exception {
    try (CommunicationManager one = announced();
        CommunicationManager two = announced()) {
      // The second may be found later than the search waits for others.
      BadInputException refusal = null;
      for (int i = 0; i < 20 && refusal == null; i++) {
        try {
          search(LONG_S);
        } catch (BadInputException e) {
          refusal = e;
        }
      }
      assertThat(refusal)
          .hasMessageContaining("several brokers of system \"" + system + "\"")
          .hasMessageContaining("127.0.0.1:" + one.address().orElseThrow().getPort())
          .hasMessageContaining("127.0.0.1:" + two.address().orElseThrow().getPort());
    }
  }

  @Test
  void theOnly_none_saysForWhomAndHowLong() {
    assertThatThrownBy(() -> search(0.2))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("no broker of system \"" + system + "\"")
        .hasMessageContaining("0.2 s");
  }
}
