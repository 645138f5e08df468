package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsFixType;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.common.SetAttitudeTarget;
import io.dronefleet.mavlink.common.SetPositionTargetLocalNed;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavState;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;

/** An autopilot in simulated time; {@link PymavlinkTest} is the outside judge of the bytes. */
class MavlinkAutopilotTest extends SimulatedAutopilot {

  private static GlobalPositionInt position(int latitude) {
    return GlobalPositionInt.builder()
        .lat(latitude)
        .lon(85455940)
        .alt(488100)
        .vx(100)
        .vy(200)
        .vz(50)
        .build();
  }

  /** Commands at 10 Hz. */
  private void commanding(String actuator, double percent, double seconds) {
    for (int i = 0; i < Math.round(10.0 * seconds); i++) {
      command(actuator, percent);
      live(0.1);
    }
  }

  /** Repeats an attitude at 10 Hz. */
  private void turned(double yaw, double seconds) {
    for (int i = 0; i < Math.round(10.0 * seconds); i++) {
      say(attitude(0.0, yaw));
      live(0.1);
    }
  }

  private boolean hasPosition() {
    return kit.published(Channels.SENSED_STATE).stream().anyMatch(each -> each.x().isPresent());
  }

  private String lastError() {
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse("");
  }

  @Test
  void step_onePositionManyAttitudes_thePositionIsPublishedOnce() {
    start();
    say(position(473977420));
    turned(0.0, 1.0);
    List<StateInformation> all = kit.published(Channels.SENSED_STATE);
    assertThat(all.stream().filter(each -> each.psi().isPresent())).hasSize(10);
    assertThat(all.stream().filter(each -> each.x().isPresent())).as("one measurement").hasSize(1);
    assertThat(all.stream().map(StateInformation::sensorName).distinct())
        .as("a newer attitude does not replace a position that nobody read yet")
        .containsExactlyInAnyOrder("MavlinkAutopilot position", "MavlinkAutopilot");
  }

  @Test
  void step_noFixOrImpossiblePosition_attitudeOnly() {
    start();
    say(attitude(0.0, 0.0));
    kit.advance(0.1);
    assertThat(hasPosition()).as("no position yet").isFalse();
    say(position(1_200_000_000));
    say(attitude(0.0, 0.0));
    kit.advance(0.1);
    assertThat(hasPosition()).as("120 degrees north").isFalse();
    say(
        GpsRawInt.builder()
            .fixType(GpsFixType.GPS_FIX_TYPE_2D_FIX)
            .timeUsec(BigInteger.ZERO)
            .build());
    say(position(473977420));
    kit.advance(0.1);
    assertThat(hasPosition()).as("the GPS has no 3D fix").isFalse();
    live(1.5);
    say(position(0));
    say(attitude(Math.PI / 2.0, 0.0));
    kit.advance(0.1);
    assertThat(hasPosition()).as("on the equator").isTrue();
    assertThat(state(StateField.PHI).psiDot()).as("not defined, straight up").isEmpty();
    kit.forget();
    say(attitude(Double.NaN, 0.0));
    kit.advance(0.3);
    assertThat(kit.published(Channels.SENSED_STATE)).isEmpty();
    assertThat(lastError()).contains("the autopilot sent invalid data");
  }

  @Test
  void step_heartbeatsAndRequests_goOut() {
    start();
    heard.clear();
    live(5.0);
    assertThat(heard(Heartbeat.class)).hasSize(5);
    assertThat(heard(CommandLong.class)).as("asked again while nothing comes").isNotEmpty();
    turned(0.0, 5.0);
    heard.clear();
    turned(0.0, 2.0);
    assertThat(heard(CommandLong.class)).as("no longer when it comes").isEmpty();
  }

  private double[] targetAngles() {
    List<Float> q = last(SetAttitudeTarget.class).q();
    double w = q.get(0);
    double x = q.get(1);
    double y = q.get(2);
    double z = q.get(3);
    return new double[] {
      Math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)),
      Math.asin(2.0 * (w * y - z * x)),
      Math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    };
  }

  @Test
  void step_attitudeCommands_areAnglesAtTheVehiclesOwnHeadingWithoutRates() {
    kit.with("COMMANDS", "attitude");
    start();
    say(attitude(0.0, 1.2));
    kit.advance(0.02);
    command("ROLL ANGLE", 40.0);
    command("PITCH ANGLE", -20.0);
    kit.advance(0.1);
    SetAttitudeTarget target = last(SetAttitudeTarget.class);
    assertThat(target.typeMask().value())
        .as("some of the three rates would stop ArduCopter")
        .isEqualTo(0b111);
    assertThat(targetAngles()[0]).isCloseTo(0.2, within(1.0e-6));
    assertThat(targetAngles()[1]).isCloseTo(-0.1, within(1.0e-6));
    assertThat(targetAngles()[2]).as("not north").isCloseTo(1.2, within(1.0e-6));
    assertThat(target.thrust()).as("neutral").isEqualTo(0.5f);
  }

  @Test
  void step_yawRateCommanded_theHeadingMovesOnAndStaysWhereItEnded() {
    kit.with("COMMANDS", "attitude").with("FULL TURN", 0.8);
    start();
    double yaw = 3.0;
    for (int i = 0; i < 20; i++) { // a vehicle that follows 0.1 s late, past south
      say(attitude(0.0, Math.IEEEremainder(yaw + 0.04 * Math.max(0, i - 1), 2.0 * Math.PI)));
      command("YAW RATE", 50.0);
      live(0.1);
    }
    // The first message is sent 0.02 s after the first command: 2 s at 0.4 rad/s, less that.
    double reached = targetAngles()[2];
    assertThat(reached).isCloseTo(Math.IEEEremainder(3.8, 2.0 * Math.PI), within(0.05));
    for (int i = 0; i < 5; i++) {
      say(attitude(0.0, reached));
      command("ROLL ANGLE", 0.0);
      command("YAW RATE", 0.0);
      live(0.1);
    }
    assertThat(targetAngles()[2]).isCloseTo(reached, within(0.02));
  }

  @Test
  void step_vehicleDoesNotFollow_theHeadingLeadsByHalfARadianAtMost() {
    kit.with("COMMANDS", "attitude");
    start();
    for (int i = 0; i < 50; i++) {
      say(attitude(0.0, -1.0));
      command("YAW RATE", 100.0);
      live(0.1);
    }
    assertThat(targetAngles()[2]).isCloseTo(-0.5, within(1.0e-3));
  }

  @Test
  void step_attitudeCommandsBeforeAnyAttitude_waitAndSaySo() {
    kit.with("COMMANDS", "attitude");
    start();
    command("ROLL ANGLE", 40.0);
    kit.advance(0.3);
    assertThat(heard(SetAttitudeTarget.class)).isEmpty();
    assertThat(lastError()).contains("commands wait").contains("ATTITUDE");
  }

  @Test
  void step_linkRefusesTheRelease_isReleasedOnceItTakesIt() {
    rc();
    command("STEERING", 80.0);
    live(1.0); // expired, and neutral
    assertThat(last(RcChannelsOverride.class).chan1Raw()).isEqualTo(1500);
    link.unplug();
    live(3.0);
    link.plug();
    heard.clear();
    live(1.0);

    assertThat(steering()).containsExactly(0);
    assertThat(steeringCount(0)).isEqualTo(3);
  }

  @Test
  void step_rcCommands_overrideThenNeutralThenGiveBack() {
    rc();
    assertThat(heard(RcChannelsOverride.class)).as("nothing before a command").isEmpty();
    command("STEERING", -50.0);
    command("THROTTLE", 25.0);
    kit.advance(0.2);
    RcChannelsOverride override = last(RcChannelsOverride.class);
    assertThat(override.chan1Raw()).isEqualTo(1250);
    assertThat(override.chan2Raw()).as("ignore").isEqualTo(65535);
    assertThat(override.chan3Raw()).isEqualTo(1250);
    assertThat(override.targetSystem()).isEqualTo(7);

    live(0.5); // the commands expire 0.5 s after they were given
    assertThat(last(RcChannelsOverride.class).chan1Raw()).as("neutral").isEqualTo(1500);
    assertThat(last(RcChannelsOverride.class).chan3Raw()).as("neutral").isEqualTo(1000);

    live(1.5);
    assertThat(last(RcChannelsOverride.class).chan1Raw()).as("given back").isZero();
    assertThat(last(RcChannelsOverride.class).chan2Raw()).isEqualTo(65535);
    assertThat(last(RcChannelsOverride.class).chan3Raw()).isZero();
    heard.clear();
    live(1.0);
    assertThat(heard(RcChannelsOverride.class)).as("then silence").isEmpty();
  }

  @Test
  void callback_emergencyStop_isNeutralBeforeTimePassesAndStays() {
    kit.with("COMMANDS", "velocity");
    start();
    command("FORWARD SPEED", 60.0);
    kit.advance(0.2);
    assertThat(last(SetPositionTargetLocalNed.class).vx()).isEqualTo(3.0f);
    heard.clear();
    stop();
    assertThat(last(SetPositionTargetLocalNed.class).vx()).isZero();
    commanding("FORWARD SPEED", 60.0, 2.0);
    assertThat(heard(SetPositionTargetLocalNed.class))
        .allSatisfy(each -> assertThat(each.vx()).isZero());
  }

  @Test
  void step_heartbeatsStopAndComeBack_actuatorsAreAnnouncedAsLostMeanwhile() {
    rc();
    assertThat(left()).isNotEmpty().containsOnly(100.0);
    speaks = false;
    live(5.0);
    assertThat(left()).containsOnly(0.0);
    speaks = true;
    live(0.5);
    assertThat(left()).containsOnly(100.0);
    service.kill();
    assertThat(left()).containsOnly(0.0);
  }

  @Test
  void kill_commanded_givesBackAtOnce() {
    rc();
    command("STEERING", 80.0);
    kit.advance(0.2);
    service.kill();
    assertThat(last(RcChannelsOverride.class).chan1Raw()).isZero();
    assertThat(link.isClosed()).isTrue();
  }

  @Test
  void step_heartbeatsEnd_isSaidAndCommandsTooUntilTheyReturn() {
    rc();
    speaks = false;
    commanding("STEERING", 80.0, 5.0);
    assertThat(lastError()).contains("the autopilot has sent no valid data for more than 3.0 s");
    assertThat(last(RcChannelsOverride.class).chan1Raw()).as("given back").isZero();
    speaks = true;
    commanding("STEERING", 80.0, 1.0);
    assertThat(last(RcChannelsOverride.class).chan1Raw()).isEqualTo(1900);
  }

  @Test
  void step_unplugged_isSaidAndItGoesOnWithinTwoSeconds() {
    rc();
    link.unplug();
    live(3.0);
    assertThat(lastError()).isEqualTo("the autopilot is lost: unplugged");
    link.plug();
    heard.clear();
    commanding("STEERING", 80.0, 2.0);
    assertThat(last(RcChannelsOverride.class).chan1Raw()).isEqualTo(1900);
    assertThat(heard(CommandLong.class)).as("asked again").isNotEmpty();
  }

  @Test
  void step_gravesWords_areTrouble() {
    start();
    say(
        Statustext.builder()
            .severity(MavSeverity.MAV_SEVERITY_CRITICAL)
            .text("EKF variance")
            .build());
    live(0.5);
    assertThat(lastError()).isEqualTo("status from the autopilot: EKF variance");
    say(heartbeat(MavState.MAV_STATE_CRITICAL));
    kit.advance(0.3);
    assertThat(lastError()).contains("MAV_STATE_CRITICAL");
  }

  @Test
  @Timeout(120)
  void step_floodThatNeverEnds_anEmergencyStopIsObeyed() {
    kit.with("COMMANDS", "rc").with("CHANNEL 1 ACTUATOR", "WHEEL");
    start();
    command("WHEEL", 50.0);
    live(0.1);
    byte[] frame = vehicle.encode(attitude(0.0, 1.0));
    link.producing(() -> link.fromDevice(frame)); // each reading finds another one

    stop();
    kit.advance(0.1);

    assertThat(last(RcChannelsOverride.class).chan1Raw()).isEqualTo(1500);
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().emergencyStops()).contains(List.of("a"));
  }

  @Test
  void step_absurdAttitude_isReportedAndMovesNoTarget() {
    kit.with("COMMANDS", "attitude");
    start();
    say(attitude(0.0, 1.0));
    live(0.1);
    kit.forget();

    say(attitude(0.0, 1.0e30));
    say(attitude(1.0e16, 1.0));
    say(attitude(0.0, 7.0));
    command("ROLL ANGLE", 0.0);
    live(0.3);

    assertThat(kit.published(Channels.SENSED_STATE)).isEmpty();
    assertThat(lastError()).contains("the autopilot sent invalid data (3 times so far)");
    assertThat(kit.log("MavlinkAutopilot"))
        .anyMatch(line -> line.contains("Attitude: ") && line.contains("is outside ±6.28"));
    List<Float> target = last(SetAttitudeTarget.class).q();
    assertThat(2.0 * Math.atan2(target.get(3), target.get(0))).isCloseTo(1.0, within(1.0e-3));
  }

  @Test
  void step_floodOfStatusTexts_logsTenLinesASecond() {
    start();
    for (int i = 0; i < 500; i++) {
      say(Statustext.builder().severity(MavSeverity.MAV_SEVERITY_INFO).text("text " + i).build());
    }
    live(0.5);
    kit.advance(1.0);
    say(Statustext.builder().severity(MavSeverity.MAV_SEVERITY_INFO).text("last").build());
    kit.advance(0.1);

    List<String> said = new ArrayList<>(kit.log("MavlinkAutopilot"));
    said.removeIf(line -> !line.contains("status from the autopilot"));
    assertThat(said).hasSizeBetween(2, 11);
    assertThat(said.get(said.size() - 1)).contains("last (after 49").contains("lines not logged)");
  }
}
