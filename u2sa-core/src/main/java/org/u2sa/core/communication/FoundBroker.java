package org.u2sa.core.communication;

import java.util.Set;

/**
 * A broker that announced itself.
 *
 * @param host its address
 * @param port its TCP port
 * @param systems IDs of the systems that talk over it; {@code *} stands for any
 * @param encrypted whether it wants TLS
 */
public record FoundBroker(String host, int port, Set<String> systems, boolean encrypted) {
  private static final String ANY = "*";

  public FoundBroker {
    systems = Set.copyOf(systems);
  }

  /** Whether the system talks over it. */
  public boolean carries(String systemId) {
    return systems.contains(systemId) || systems.contains(ANY);
  }

  @Override
  public String toString() {
    return host
        + ":"
        + port
        + " ("
        + (systems.contains(ANY) ? "any system" : String.join(", ", systems))
        + (encrypted ? ", TLS)" : ")");
  }
}
