package org.u2sa.gcs.mavlink.event;

import io.dronefleet.mavlink.common.CurrentEventSequence;
import io.dronefleet.mavlink.common.MavEventCurrentSequenceFlags;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.mavlink.telemetry.Uptime;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/**
 * Derives events from a vehicle's messages. Messages arrive on the transport's thread; everything
 * else runs on the bridge's thread.
 */
public final class VehicleEvents {
  /** Channels whose messages {@link #take} expects. */
  public static final List<Channel<?>> CHANNELS = List.of(Channels.ARMING, Channels.ARMING_STATE);

  private static final long RESET_MILLIS = 3_000;

  private final VehicleStatus vehicle;
  private final Uptime uptime;
  private final EventLog log;
  private volatile String arming = ""; // request ID of the newest order to arm
  private volatile ArmingState refusal; // null before the first
  private ArmingState toldRefusal;
  private FailsafeAction action = FailsafeAction.CONTINUE;
  private int causes;
  private boolean isArmed;
  private boolean isPursuing;

  public VehicleEvents(VehicleStatus vehicle, Uptime uptime) {
    this.vehicle = vehicle;
    this.uptime = uptime;
    log = new EventLog(uptime);
  }

  EventLog log() {
    return log;
  }

  /** Takes a message of any of {@link #CHANNELS}. */
  public void take(U2SAData message) {
    if (message instanceof ArmCommand command && command.arm()) {
      arming = command.requestId();
    } else if (message instanceof ArmingState state
        && !state.armed()
        && state.requestId().filter(arming::equals).isPresent()) {
      refusal = state;
    }
  }

  /**
   * Adds the events since the last call.
   *
   * @param reached items reached since then
   */
  public void step(List<Object> reached) {
    if (refusal != toldRefusal) {
      toldRefusal = refusal;
      int reasons = EventCause.bits(toldRefusal.reasons());
      log.add(EventType.ARMING_REFUSED, EventLog.arguments().putInt(reasons));
    }
    if (isArmed != vehicle.isArmed()) {
      isArmed = !isArmed;
      log.add(isArmed ? EventType.ARMED : EventType.DISARMED, EventLog.arguments());
    }
    stepFailsafe();
    for (Object each : reached) {
      int item = ((MissionItemReached) each).seq();
      log.add(EventType.ITEM_REACHED, EventLog.arguments().putShort((short) item));
    }
    boolean pursues = vehicle.current().isPresent();
    if (isPursuing && !pursues) {
      log.add(EventType.MISSION_OVER, EventLog.arguments());
    }
    isPursuing = pursues;
  }

  private void stepFailsafe() {
    FailsafeAction now = vehicle.failsafe();
    int stopped = vehicle.isStopped() ? EventCause.EMERGENCY_STOP.bit() : 0;
    int bits = EventCause.bits(vehicle.failsafeCauses()) | stopped;
    boolean isNew = now != action || bits != causes;
    if (isNew && now != FailsafeAction.CONTINUE) {
      log.add(EventType.FAILSAFE, EventLog.arguments().put((byte) now.ordinal()).putInt(bits));
    } else if (isNew && action != FailsafeAction.CONTINUE) {
      log.add(EventType.FAILSAFE_OVER, EventLog.arguments());
    }
    action = now;
    causes = bits;
  }

  /** CURRENT_EVENT_SEQUENCE. The first one announces that the numbers restart. */
  @SuppressWarnings("deprecation") // the library predates the message's final form
  public Optional<Object> sequence() {
    CurrentEventSequence.Builder message = CurrentEventSequence.builder().sequence(log.newest());
    return Optional.of(
        message
            .flags(
                uptime.millis() < RESET_MILLIS
                    ? EnumValue.of(
                        MavEventCurrentSequenceFlags.MAV_EVENT_CURRENT_SEQUENCE_FLAGS_RESET)
                    : EnumValue.create(MavEventCurrentSequenceFlags.class, 0))
            .build());
  }
}
