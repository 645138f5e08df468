package org.u2sa.benchmarks.fleet;

import java.util.Map;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;

/** Our broker in a process of its own, so that its processor time is its own. Takes the port. */
final class EmbeddedBroker {
  private static final int CLIENTS = 100_000; // 512 unless configured

  private EmbeddedBroker() {}

  public static void main(String[] args) throws Exception {
    Map<String, Object> settings =
        Map.of("COMMUNICATION MANAGER PORT", Integer.parseInt(args[0]), "MAX CLIENTS", CLIENTS);
    try (CommunicationManager manager =
        CommunicationManager.start(
            "ground",
            XmlConfiguration.inMemory("CommunicationManager", settings),
            StandardTypes.registry(),
            System.err::println)) {
      System.in.read(); // it ends with its input
    }
  }
}
