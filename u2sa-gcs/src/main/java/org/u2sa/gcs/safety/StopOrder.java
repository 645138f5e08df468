package org.u2sa.gcs.safety;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.UUID;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

/**
 * Sends an emergency stop to each system as soon as the system is known, and then collects the
 * confirmations.
 */
public final class StopOrder {
  /** Time in which a service with the default report period reports twice. */
  private static final double LISTEN_S = 0.6;

  /** The Safety Manager's arming state is retained, so it arrives immediately if it exists. */
  private static final double RETAINED_WITHIN_S = 0.1;

  /** Maximum number of systems that one order stops. */
  public static final int MAX_SYSTEMS = 64; // caps memory against spoofed systems

  private final RemoteLink link;
  private final Clock.Waiter waiter;
  private final String operator;
  private final String reason;
  private final String stopId;
  private final Map<String, String> sent = new TreeMap<>(); // failure, or ""; guarded by this
  private boolean leftSome; // guarded by this
  private final SortedMap<String, StopConfirmation> vehicles = new TreeMap<>();

  /**
   * @param link to one system, or to all
   * @param waiter used by {@link #await} only
   * @param operator author of the stop
   * @param reason reason for the stop, for the logs
   */
  public StopOrder(RemoteLink link, Clock.Waiter waiter, String operator, String reason) {
    this.link = link;
    this.waiter = waiter;
    this.operator = operator;
    this.reason = reason;
    stopId = operator + " " + UUID.randomUUID();
  }

  /** Sends the stop to a system, once. */
  public void send(String systemId) {
    synchronized (this) {
      if (sent.containsKey(systemId)) {
        return;
      }
      if (sent.size() >= MAX_SYSTEMS) {
        leftSome = true;
        return;
      }
      sent.put(systemId, published(systemId));
    }
    waiter.signal();
  }

  private String published(String systemId) {
    EmergencyStop stop = new EmergencyStop().active(true).stopId(stopId);
    stop.operator(operator).reason(reason).systemId(systemId);
    try {
      link.publish(Channels.EMERGENCY_STOP, stop);
      return "";
    } catch (CommunicationException | IllegalArgumentException e) { // or an invalid system ID
      return e.getMessage();
    }
  }

  /**
   * Sends the stop to every system as soon as it is discovered, on the transport's thread, without
   * waiting for the others.
   */
  public void sendToAllHeard() throws InterruptedException {
    link.listen(Channels.ARMING_STATE, this::heard);
    link.await(this::isSent, Math.min(RETAINED_WITHIN_S, link.timeoutS()));
    link.listen(Channels.HEALTH, this::heard); // also for systems without a Safety Manager
  }

  private void heard(U2SAData message) {
    if (!message.systemId().isEmpty()) {
      send(message.systemId());
    }
  }

  private synchronized boolean isSent() {
    return !sent.isEmpty();
  }

  private synchronized Map<String, String> sent() {
    return new TreeMap<>(sent);
  }

  /**
   * Waits until every known system has confirmed the stop, but at least as long as two reports
   * take.
   *
   * @return the systems to which the stop was sent; empty if none was found
   */
  public SortedMap<String, StopConfirmation> await() throws InterruptedException {
    long begun = link.clock().micros();
    long least = begun + Clock.micros(Math.min(LISTEN_S, link.timeoutS()));
    long most = begun + Clock.micros(link.timeoutS());
    while (true) {
      sent()
          .keySet()
          .forEach(
              system ->
                  vehicles.computeIfAbsent(
                      system, id -> StopConfirmation.listen(link, id, waiter)));
      long now = link.clock().micros();
      if (now >= most || now >= least && isConfirmed()) {
        return vehicles;
      }
      waiter.await(now < least ? least : most);
    }
  }

  private boolean isConfirmed() {
    return !vehicles.isEmpty()
        && vehicles.values().stream().allMatch(vehicle -> vehicle.missing(holds()).isEmpty());
  }

  /** The condition that a service holds this stop. */
  public StopConfirmation.Outcome holds() {
    return held -> held.contains(stopId);
  }

  /** Whether more than {@link #MAX_SYSTEMS} systems were found, so that some were not stopped. */
  public synchronized boolean leftSome() {
    return leftSome;
  }

  /** Reason why the stop was not sent to a system; empty if it was. */
  public String failure(String systemId) {
    return sent().getOrDefault(systemId, "");
  }
}
