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

/**
 * The conversation beside measurements and commands: who the autopilot is, heartbeats both ways,
 * which messages it is to send, and what it says of itself.
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
  private int system; // 0: not known yet
  private long heartbeatDueMicros = Long.MIN_VALUE;
  private long askDueMicros = Long.MIN_VALUE;
  private long streamedMicros = Long.MIN_VALUE / 2;
  private Optional<Boolean> armed = Optional.empty();
  private MavState said;

  /**
   * @param system the autopilot's ID; 0: whichever is heard first
   * @param stateHz how often it is to send attitude and position [Hz]
   * @param out takes the messages to send
   */
  AutopilotPeer(int system, double stateHz, Consumer<Object> out) {
    this.system = system;
    this.stateHz = stateHz;
    this.out = out;
  }

  /** Whether a message is the autopilot's; the first autopilot's heartbeat settles who that is. */
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

  /** To whom commands go; empty until it is known. */
  Optional<CommandForm.Target> target() {
    return system == 0
        ? Optional.empty()
        : Optional.of(new CommandForm.Target(system, AUTOPILOT_COMPONENT));
  }

  /** Sends the own heartbeat, and asks for messages that do not come. */
  void step(boolean isHeard, long nowMicros) {
    if (nowMicros >= heartbeatDueMicros) {
      heartbeatDueMicros = nowMicros + HEARTBEAT_MICROS;
      out.accept(
          Heartbeat.builder()
              .type(MavType.MAV_TYPE_ONBOARD_CONTROLLER)
              .autopilot(MavAutopilot.MAV_AUTOPILOT_INVALID)
              .systemStatus(MavState.MAV_STATE_ACTIVE)
              .baseMode(EnumValue.create(0))
              .mavlinkVersion(MAVLINK_VERSION)
              .build());
    }
    boolean isSilent = nowMicros - streamedMicros > STREAMS_STOPPED_MICROS;
    if (isHeard && isSilent && nowMicros >= askDueMicros) {
      askDueMicros = nowMicros + ASK_AGAIN_MICROS;
      ATTITUDE_AND_POSITION.forEach(message -> ask(message, stateHz));
      SLOW.forEach(message -> ask(message, SLOW_HZ));
    }
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

  /** Takes note that what was asked for comes. */
  void streams(long nowMicros) {
    streamedMicros = nowMicros;
  }

  /** Tells of arming, and of states that are trouble, when they change. */
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

  /** Passes on what it says in words. */
  void take(Statustext text, Consumer<String> log, Consumer<String> trouble) {
    boolean isGrave = text.severity().value() <= MavSeverity.MAV_SEVERITY_ERROR.ordinal();
    (isGrave ? trouble : log).accept("the autopilot says: " + text.text());
  }
}
