package org.u2sa.core.communication.access;

import java.util.HashSet;
import java.util.Set;
import org.u2sa.interfaces.mqtt.ClientIds;

/** A connection that publishes under source names. For the network's thread only. */
public final class Speaker {
  /** A live service reports its health four times a second. */
  private static final long SILENT_MICROS = 5_000_000;

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

  /**
   * Whether it may take a name over.
   *
   * @param holder that has it; null if none
   */
  boolean mayReplace(Speaker holder, long nowMicros) {
    return holder == null
        || isOfVehicle
        || isSameAs(holder)
        || nowMicros - holder.spokeMicros > SILENT_MICROS;
  }

  Set<String> held() {
    return held;
  }

  /** Notes a message in any name. */
  void spoke(long nowMicros) {
    spokeMicros = nowMicros;
  }
}
