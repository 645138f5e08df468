package org.u2sa.gcs.mavlink.vehicle;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.u2sa.gcs.mavlink.vehicle.OrdersUnderWay.Kind;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.schema.U2SAData;

/** Orders of one station to the vehicle. */
public final class VehicleOrders {
  /** Receives the result of an order. */
  @FunctionalInterface
  public interface Answer {
    /**
     * Called once, unless {@link #failed} is.
     *
     * @param text what was done, or the reason for the failure
     */
    void done(boolean accepted, String text);

    /** Called instead of {@link #done} if it is unknown whether the vehicle obeys. */
    default void failed(String text) {
      done(false, text);
    }

    /** Called from time to time before one of the others. */
    default void inProgress() {}
  }

  private static final Set<MissionAction> CALM =
      EnumSet.of(MissionAction.PAUSE, MissionAction.RETURN, MissionAction.LAND);

  private final OrdersUnderWay all;
  private final Map<Kind, Integer> taken = new EnumMap<>(Kind.class); // places
  private boolean isClosed;

  /**
   * @param all orders of all stations
   */
  public VehicleOrders(OrdersUnderWay all) {
    this.all = all;
  }

  /** Arms or disarms. */
  public void arm(boolean arm, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(
        id,
        arm ? Kind.ARM : Kind.DISARM,
        Channels.ARMING,
        new ArmCommand().requestId(id).arm(arm).operator(all.operator()),
        answer);
  }

  /** Stops the vehicle; accepted once a service reports that the stop is in force. */
  public void stop(String reason, Answer answer) {
    send(
        UUID.randomUUID().toString(),
        Kind.STOP,
        Channels.EMERGENCY_STOP,
        new EmergencyStop()
            .active(true)
            .operator(all.operator())
            .reason(reason)
            .stopId(all.stopId()),
        answer);
  }

  /** Changes the mission. */
  public void mission(MissionOrder order, Answer answer) {
    String id = UUID.randomUUID().toString();
    Kind kind = CALM.contains(order.action()) ? Kind.HOLD : Kind.OTHER;
    send(id, kind, Channels.MISSION, order.requestId(id).operator(all.operator()), answer);
  }

  /**
   * Replaces the Path Planner's class.
   *
   * @param index index of a class; empty: that of the mode Mission
   */
  public void plan(PlannerModes planners, Optional<Integer> index, Answer answer) {
    String id = UUID.randomUUID().toString();
    ServiceOrder order =
        new ServiceOrder()
            .requestId(id)
            .serviceName(planners.service())
            .action(ServiceAction.SWAP)
            .className(planners.className(index))
            .operator(all.operator());
    send(
        id,
        Kind.OTHER,
        Channels.SERVICE_ORDERS,
        order,
        (swapped, why) -> {
          tell(Channels.DISCOVERY, new DiscoveryRequest());
          answer.done(swapped, why);
        });
  }

  /**
   * Begins or ends driving by hand.
   *
   * @param driver name of the driver
   */
  public void manual(boolean active, String driver, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(
        id,
        active ? Kind.DRIVE : Kind.RELEASE,
        Channels.MANUAL_ORDERS,
        new ManualOrder().requestId(id).active(active).operator(driver),
        answer);
  }

  /** Changes the fence. */
  public void fence(FenceOrder order, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(
        id,
        Kind.OTHER,
        Channels.FENCE_ORDERS,
        order.requestId(id).operator(all.operator()),
        answer);
  }

  public void configure(ConfigurationTransaction change, Answer answer) {
    String id = UUID.randomUUID().toString();
    send(
        id,
        Kind.CONFIGURE,
        Channels.CONFIGURATION,
        change.requestId(id).author(all.operator()),
        answer);
  }

  /** Publishes a message that expects no answer. */
  public void tell(Channel<?> channel, U2SAData message) {
    all.tell(channel, message);
  }

  private void send(String id, Kind kind, Channel<?> channel, U2SAData order, Answer answer) {
    all.send(this, kind, id, channel, order, answer);
  }

  boolean takePlace(Kind kind, int places) {
    boolean isFree = taken.getOrDefault(kind, 0) < places;
    if (isFree) {
      taken.merge(kind, 1, Integer::sum);
    }
    return isFree;
  }

  void leavePlace(Kind kind) {
    taken.merge(kind, -1, Integer::sum);
  }

  /** The station has left: what has not been published is dropped. */
  public void close() {
    isClosed = true;
    all.forget(this);
  }

  boolean isClosed() {
    return isClosed;
  }
}
