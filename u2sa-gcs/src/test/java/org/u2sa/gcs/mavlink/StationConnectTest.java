package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.HomePosition;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavProtocolCapability;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.MessageInterval;
import io.dronefleet.mavlink.common.Ping;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.common.Timesync;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.ArmingState;

/** What stations ask for when they connect, in QGroundControl's order, and what they trip over. */
@SuppressWarnings("deprecation") // stations still send these
class StationConnectTest {
  private static final int REQUEST_MESSAGE = 512;
  private static final int SET_INTERVAL = 511;

  private final BridgeKit kit = BridgeKit.rover().ready();

  private MavResult result() {
    List<CommandAck> answers = kit.received(CommandAck.class);
    assertThat(answers).hasSize(1);
    return answers.get(0).result().entry();
  }

  @Test
  void requestMessage_autopilotVersion_claimsAFenceAndRallyPoints() {
    kit.command(REQUEST_MESSAGE, 148);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
    AutopilotVersion version = kit.received(AutopilotVersion.class).get(0);
    assertThat(version.flightSwVersion()).isNotZero();
    EnumValue<MavProtocolCapability> claimed = version.capabilities();
    assertThat(claimed.flagsEnabled(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_INT))
        .isTrue();
    assertThat(claimed.flagsEnabled(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_COMMAND_INT))
        .isTrue();
    assertThat(claimed.flagsEnabled(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE))
        .isTrue();
    assertThat(claimed.flagsEnabled(MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY))
        .isTrue();
  }

  @Test
  void requestMessage_availableModes_sendsEachBeforeTheAnswer() {
    assertThat(kit.vehicle.telemetry.modes()).isEqualTo(5);
    kit.command(REQUEST_MESSAGE, 435, 0);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
    kit.command(REQUEST_MESSAGE, 435, 6);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_DENIED);
  }

  @Test
  void command_everyKnownOne_isAnsweredExactlyOnceThoughItMayBeInProgressBefore() {
    for (MavCmd each : MavCmd.values()) {
      kit.command(EnumValue.of(each).value());
      kit.advance(4.0); // the scripted vehicle answers nothing
      List<CommandAck> answers = finalAnswers();
      if (answers.isEmpty()) { // an order to stop or disarm
        kit.advance(30.0);
        answers = finalAnswers();
      }
      assertThat(answers).as(each.name()).hasSize(1);
      assertThat(answers.get(0).command().value()).isEqualTo(EnumValue.of(each).value());
    }
    kit.command(31_000);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_UNSUPPORTED);
  }

  private List<CommandAck> finalAnswers() {
    return kit.received(CommandAck.class).stream()
        .filter(ack -> ack.result().entry() != MavResult.MAV_RESULT_IN_PROGRESS)
        .toList();
  }

  @Test
  void heartbeat_whateverIsAsked_comesEverySecond() {
    kit.command(SET_INTERVAL, 0, -1);
    kit.received(Heartbeat.class);
    kit.advance(10.0);
    assertThat(kit.received(Heartbeat.class)).hasSizeBetween(9, 11);
  }

  @Test
  void sysStatus_reasonsAgainstArming_isNotReady() {
    assertThat(isReady()).isTrue();
    kit.says(new ArmingState().armed(false).reasons(List.of("no position")));
    assertThat(isReady()).isFalse();
  }

  private boolean isReady() {
    kit.received(SysStatus.class);
    kit.command(REQUEST_MESSAGE, 1);
    kit.received(CommandAck.class);
    SysStatus status = kit.received(SysStatus.class).get(0);
    MavSysStatusSensor checks = MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK;
    assertThat(status.onboardControlSensorsEnabled().flagsEnabled(checks)).isTrue();
    return status.onboardControlSensorsHealth().flagsEnabled(checks);
  }

  @Test
  void globalPosition_unknownOrLocal_isNotSentAsZero() {
    BridgeKit blind = BridgeKit.rover();
    blind.advance(2.0);
    blind.says(new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU).x(1.0).y(2.0));
    blind.advance(2.0);
    assertThat(blind.received(GlobalPositionInt.class)).isEmpty();
    assertThat(blind.received(HomePosition.class)).isEmpty();
  }

  @Test
  void globalPosition_estimateStops_isNotRepeated() {
    kit.advance(1.0);
    GlobalPositionInt position = kit.received(GlobalPositionInt.class).get(0);
    assertThat(position.lat()).isEqualTo(540_000_000);
    assertThat(position.lon()).isEqualTo(100_000_000);
    assertThat(position.alt()).isEqualTo(3000);
    assertThat(position.hdg()).isEqualTo(5730); // 1 rad
    kit.advance(3.0);
    kit.received(GlobalPositionInt.class);
    kit.advance(3.0);
    assertThat(kit.received(GlobalPositionInt.class)).isEmpty();
  }

  @Test
  void setInterval_rate_isKept() {
    kit.command(SET_INTERVAL, 33, 50_000);
    assertThat(result()).isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
    kit.command(510, 33);
    assertThat(kit.received(MessageInterval.class).get(0).intervalUs()).isEqualTo(50_000);
    kit.command(SET_INTERVAL, 33, 1e30);
    kit.received(GlobalPositionInt.class);
    kit.advance(2.0);
    assertThat(kit.received(GlobalPositionInt.class)).isEmpty();
    kit.command(SET_INTERVAL, 33, 1); // no faster than 50 Hz
    kit.command(510, 33);
    assertThat(kit.received(MessageInterval.class).get(0).intervalUs()).isEqualTo(20_000);
  }

  @Test
  void timesyncAndPing_requests_areAnswered() {
    kit.send(Timesync.builder().tc1(0).ts1(42).build());
    assertThat(kit.received(Timesync.class).get(0).ts1()).isEqualTo(42);
    kit.send(Timesync.builder().tc1(7).ts1(42).build()); // an answer
    assertThat(kit.received(Timesync.class)).isEmpty();
    kit.send(Ping.builder().timeUsec(BigInteger.TEN).seq(3).build());
    assertThat(kit.received(Ping.class).get(0).targetSystem()).isEqualTo(BridgeKit.STATION);
  }
}
