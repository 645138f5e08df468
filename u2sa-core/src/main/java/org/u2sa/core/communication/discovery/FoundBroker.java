package org.u2sa.core.communication.discovery;

import java.util.Set;

/**
 * An announced broker.
 *
 * @param host IP address or host name
 * @param port its TCP port
 * @param systems IDs of the systems on it; {@code *} for any
 * @param encrypted whether it requires TLS
 */
public record FoundBroker(String host, int port, Set<String> systems, boolean encrypted) {
  private static final String ANY = "*";

  /** Copies the systems. */
  public FoundBroker {
    systems = Set.copyOf(systems);
  }

  /** Whether the system is on this broker. */
  public boolean carries(String systemId) {
    return systems.contains(systemId) || systems.contains(ANY);
  }

  @Override
  public String toString() {
    return String.format(
        "%s:%s (%s%s",
        host,
        port,
        systems.contains(ANY) ? "any system" : String.join(", ", systems),
        encrypted ? ", TLS)" : ")");
  }
}
