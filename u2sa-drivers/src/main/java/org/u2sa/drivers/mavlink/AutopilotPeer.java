package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.mavlink.MavlinkStream;

/**
 * Session with the autopilot: identification, heartbeats both ways, message rates, and status
 * texts.
 */
final class AutopilotPeer {
  private static final long HEARTBEAT_MICROS = Clock.micros(1.0);
  private static final long ASK_AGAIN_MICROS = Clock.micros(1.0);
  private static final long STREAMS_STOPPED_MICROS = Clock.micros(1.5);
  private static final int AUTOPILOT_COMPONENT = 1; // MAV_COMP_ID_AUTOPILOT1
  private static final int MAVLINK_VERSION = 3;
  private static final List<Integer> ATTITUDE_AND_POSITION = List.of(30, 33); // message IDs
  private static final List<Integer> SLOW = List.of(1, 24, 147); // SYS_STATUS, GPS_RAW, BATTERY
  private static final double SLOW_HZ = 2.0;
  private static final double MICROS_PER_S = 1.0e6;

  private final double stateHz;
  private final Consumer<Object> out;
  private int system; // 0 until known
  private long heartbeatDueMicros = Long.MIN_VALUE;
  private long askDueMicros = Long.MIN_VALUE;
  private long streamedMicros = Long.MIN_VALUE / 2;
  private Optional<Boolean> armed = Optional.empty();
  private MavState said;

  /**
   * @param system the autopilot's system ID; 0 for the first one that reports
   * @param stateHz requested rate of attitude and position [Hz]
   * @param out receives the messages to send
   */
  AutopilotPeer(int system, double stateHz, Consumer<Object> out) {
    this.system = system;
    this.stateHz = stateHz;
    this.out = out;
  }

  /** Whether a message is from the autopilot, which the first autopilot heartbeat identifies. */
  boolean isFrom(MavlinkStream.Received message) {
    boolean isAutopilot =
        message.payload() instanceof Heartbeat heartbeat
            && message.componentId() == AUTOPILOT_COMPONENT
            && heartbeat.autopilot().entry() != MavAutopilot.MAV_AUTOPILOT_INVALID;
    if (system == 0 && isAutopilot) {
      system = message.systemId();
    }
    return system != 0
        && message.systemId() == system
        && message.componentId() == AUTOPILOT_COMPONENT;
  }

  /** Target of commands; empty until known. */
  Optional<CommandForm.Target> target() {
    return system == 0
        ? Optional.empty()
        : Optional.of(new CommandForm.Target(system, AUTOPILOT_COMPONENT));
  }

  /** Sends our heartbeat and requests missing messages. */
  void step(boolean isHeard, long nowMicros) {
    if (nowMicros >= heartbeatDueMicros) {
      heartbeatDueMicros = nowMicros + HEARTBEAT_MICROS;
      out.accept(heartbeat());
    }
    boolean isSilent = nowMicros - streamedMicros > STREAMS_STOPPED_MICROS;
    if (isHeard && isSilent && nowMicros >= askDueMicros) {
      askDueMicros = nowMicros + ASK_AGAIN_MICROS;
      ATTITUDE_AND_POSITION.forEach(message -> ask(message, stateHz));
      SLOW.forEach(message -> ask(message, SLOW_HZ));
    }
  }

  static Heartbeat heartbeat() {
    return Heartbeat.builder()
        .type(MavType.MAV_TYPE_ONBOARD_CONTROLLER)
        .autopilot(MavAutopilot.MAV_AUTOPILOT_INVALID)
        .systemStatus(MavState.MAV_STATE_ACTIVE)
        .baseMode(EnumValue.create(0))
        .mavlinkVersion(MAVLINK_VERSION)
        .build();
  }

  private void ask(int message, double hz) {
    out.accept(
        CommandLong.builder()
            .targetSystem(system)
            .targetComponent(AUTOPILOT_COMPONENT)
            .command(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL)
            .param1(message)
            .param2((float) (MICROS_PER_S / hz))
            .build());
  }

  /** Marks a requested message as received. */
  void streams(long nowMicros) {
    streamedMicros = nowMicros;
  }

  /** Reports changes of arming and of fault states. */
  void take(Heartbeat heartbeat, Consumer<String> log, Consumer<String> trouble) {
    boolean isArmed = heartbeat.baseMode().flagsEnabled(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED);
    if (armed.isEmpty() || armed.get() != isArmed) {
      armed = Optional.of(isArmed);
      log.accept("the autopilot, system " + system + ", is " + (isArmed ? "armed" : "disarmed"));
    }
    MavState now = heartbeat.systemStatus().entry();
    if (now != said) {
      said = now;
      if (now == MavState.MAV_STATE_CRITICAL || now == MavState.MAV_STATE_EMERGENCY) {
        trouble.accept("the autopilot is in state " + now);
      }
    }
  }

  /** Forwards status texts. */
  void take(Statustext text, Consumer<String> log, Consumer<String> trouble) {
    boolean isGrave = text.severity().value() <= MavSeverity.MAV_SEVERITY_ERROR.ordinal();
    (isGrave ? trouble : log).accept("status from the autopilot: " + text.text());
  }
}
