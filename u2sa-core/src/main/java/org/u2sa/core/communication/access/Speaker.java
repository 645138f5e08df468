package org.u2sa.core.communication.access;

import java.util.HashSet;
import java.util.Set;
import org.u2sa.interfaces.mqtt.ClientIds;

/** A connection that publishes under source names. For the network's thread only. */
public final class Speaker {
  private final String sender;
  private final boolean isOfVehicle;
  private final Set<String> held = new HashSet<>(); // keys
  private long spokeMicros;

  /**
   * @param user the client's user name, or that of all clients without users
   */
  public Speaker(String user, String clientId) {
    String of = ClientIds.senderOf(clientId);
    isOfVehicle = of.equals(ClientIds.run());
    sender = user + " " + of;
  }

  /** Whether it is of the broker's process or of a process that this one started. */
  boolean isOfVehicle() {
    return isOfVehicle;
  }

  /** Whether both are of one process, or of processes that share their run. */
  boolean isSameAs(Speaker other) {
    return isOfVehicle && other.isOfVehicle || sender.equals(other.sender);
  }

  /** Keys of the names that it holds. */
  Set<String> held() {
    return held;
  }

  void spoke(long nowMicros) {
    spokeMicros = nowMicros;
  }

  /** Time of its last message in any name. */
  long spokeMicros() {
    return spokeMicros;
  }
}
