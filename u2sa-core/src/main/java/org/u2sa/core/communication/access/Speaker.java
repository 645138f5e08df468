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
   * @param user the client's user name, or the common name of clients without users
   */
  public Speaker(String user, String clientId) {
    String of = ClientIds.senderOf(clientId);
    isOfVehicle = of.equals(ClientIds.run());
    sender = user + " " + of;
  }

  /** Whether the connection belongs to the broker's process or to a process that it started. */
  boolean isOfVehicle() {
    return isOfVehicle;
  }

  /** Whether both connections belong to one process, or to processes of one run. */
  boolean isSameAs(Speaker other) {
    return isOfVehicle && other.isOfVehicle || sender.equals(other.sender);
  }

  /**
   * Whether this connection may take over a name.
   *
   * @param holder current holder of the name, or null
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

  /** Records a message published under any name. */
  void spoke(long nowMicros) {
    spokeMicros = nowMicros;
  }
}
