package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.drivers.link.RealTime;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.testkit.NeedsProgram;

/** The outside judge: pymavlink plays the vehicle, over TCP and UDP, in real time. */
@NeedsProgram(value = "python3", modules = "pymavlink.mavutil")
class PymavlinkTest {
  @TempDir Path logs;

  private RealTime real;
  private PymavlinkVehicle vehicle;

  @BeforeEach
  void begin() {
    real = new RealTime(logs);
  }

  private void start(String kind) throws Exception {
    vehicle = PymavlinkVehicle.start(kind);
    real.with("CONNECTION", kind + ":127.0.0.1:" + vehicle.port()).start(MavlinkAutopilot::new);
  }

  @AfterEach
  void end() throws Exception {
    real.close();
    if (vehicle != null) {
      vehicle.close();
    }
  }

  /** A number in a line of JSON. */
  private static double number(String json, String field) {
    Matcher matcher = Pattern.compile("\"" + field + "\": (-?[0-9.e-]+)").matcher(json);
    assertThat(matcher.find()).as(field + " in " + json).isTrue();
    return Double.parseDouble(matcher.group(1));
  }

  private String last(String type) {
    List<String> all = vehicle.heard(type);
    return all.isEmpty() ? "" : all.get(all.size() - 1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"tcp", "udp"})
  void vehicleSpeaks_stateAndPowerArePublished(String kind) throws Exception {
    start(kind);
    real.until(() -> sensed(StateField.PHI).isPresent() && sensed(StateField.X_SIGMA).isPresent());
    StateInformation state = sensed(StateField.X_SIGMA).orElseThrow();
    assertThat(state.y().getAsDouble()).isCloseTo(47.397742, within(1.0e-9));
    assertThat(state.x().getAsDouble()).isCloseTo(8.545594, within(1.0e-9));
    assertThat(state.z()).hasValue(488.1);
    assertThat(state.xDot()).hasValue(2.0);
    assertThat(state.yDot()).hasValue(1.0);
    assertThat(state.zDot()).hasValue(-0.5);
    assertThat(state.xSigma().getAsDouble()).isCloseTo(0.8 / Math.sqrt(2.0), within(1.0e-9));
    state = sensed(StateField.PHI).orElseThrow();
    assertThat(state.phi().getAsDouble()).isCloseTo(0.1, within(1.0e-6));
    assertThat(state.theta().getAsDouble()).isCloseTo(-0.2, within(1.0e-6));
    assertThat(state.psi().getAsDouble()).isCloseTo(2.0 * Math.PI - 1.5, within(1.0e-6));
    real.until(() -> real.latest(Channels.POWER).isPresent());
    BatteryState battery = real.latest(Channels.POWER).orElseThrow();
    assertThat(battery.voltage().getAsDouble()).isCloseTo(15.2, within(1.0e-9));
    assertThat(battery.current().getAsDouble()).isCloseTo(12.3, within(1.0e-9));
    assertThat(battery.remaining()).hasValue(64.0);

    real.until(() -> vehicle.heard("HEARTBEAT").size() >= 2);
    String heartbeat = last("HEARTBEAT");
    assertThat(heartbeat).contains("\"from\": [255, 191]");
    assertThat(number(heartbeat, "type")).as("onboard controller").isEqualTo(18.0);
    assertThat(number(heartbeat, "autopilot")).as("none").isEqualTo(8.0);
    assertThat(vehicle.heard("BAD_DATA")).isEmpty();
  }

  /** The newest with that number. */
  private Optional<StateInformation> sensed(StateField field) {
    return real.published(Channels.SENSED_STATE).stream()
        .filter(state -> state.number(field).isPresent())
        .reduce((first, second) -> second);
  }

  @Test
  void commandsToRadioChannels_overrideNeutralAndGiveBack() throws Exception {
    real.with("COMMANDS", "rc");
    real.with("CHANNEL 1 ACTUATOR", "STEERING");
    real.with("CHANNEL 3 ACTUATOR", "THROTTLE");
    real.with("NEUTRAL TIME", 0.5);
    start("tcp");
    real.until(
        () -> {
          real.command("STEERING", 50.0);
          real.command("THROTTLE", -20.0);
          String override = last("RC_CHANNELS_OVERRIDE");
          return !override.isEmpty() && number(override, "chan3_raw") == 1400.0;
        });
    String override = last("RC_CHANNELS_OVERRIDE");
    assertThat(number(override, "chan1_raw")).isEqualTo(1750.0);
    assertThat(number(override, "chan2_raw")).as("ignore").isEqualTo(65535.0);
    assertThat(number(override, "target_system")).isEqualTo(7.0);
    assertThat(number(override, "target_component")).isEqualTo(1.0);

    real.until(() -> number(last("RC_CHANNELS_OVERRIDE"), "chan1_raw") == 0.0);
    assertThat(number(last("RC_CHANNELS_OVERRIDE"), "chan3_raw")).as("given back").isZero();
    assertThat(vehicle.heard("RC_CHANNELS_OVERRIDE"))
        .as("neutral before")
        .anySatisfy(each -> assertThat(number(each, "chan1_raw")).isEqualTo(1500.0));
    assertThat(vehicle.heard("BAD_DATA")).isEmpty();
  }

  @Test
  void commandsAsVelocities_untilTheEmergencyStop() throws Exception {
    real.with("COMMANDS", "velocity");
    start("udp");
    real.until(
        () -> {
          real.command("FORWARD SPEED", 50.0);
          real.command("LEFT SPEED", 20.0);
          real.command("CLIMB SPEED", 25.0);
          real.command("TURN RATE", -25.0);
          String target = last("SET_POSITION_TARGET_LOCAL_NED");
          return !target.isEmpty() && number(target, "yaw_rate") == 0.25;
        });
    String target = last("SET_POSITION_TARGET_LOCAL_NED");
    assertThat(number(target, "coordinate_frame")).as("BODY_NED").isEqualTo(8.0);
    assertThat(number(target, "type_mask")).isEqualTo(1479.0);
    assertThat(number(target, "vx")).isEqualTo(2.5);
    assertThat(number(target, "vy")).isEqualTo(-1.0);
    assertThat(number(target, "vz")).isEqualTo(-0.5);

    EmergencyStop stop = new EmergencyStop().operator("the test").reason("test").active(true);
    real.send(Channels.EMERGENCY_STOP, stop);
    real.until(() -> number(last("SET_POSITION_TARGET_LOCAL_NED"), "vx") == 0.0);
    assertThat(number(last("SET_POSITION_TARGET_LOCAL_NED"), "yaw_rate")).isZero();
  }

  @Test
  void commandsAsAttitude_anglesArePymavlinks() throws Exception {
    real.with("COMMANDS", "attitude");
    start("tcp");
    real.until(
        () -> {
          real.command("ROLL ANGLE", 40.0);
          real.command("PITCH ANGLE", -20.0);
          real.command("YAW RATE", 30.0);
          real.command("THRUST", 75.0);
          String target = last("SET_ATTITUDE_TARGET");
          return !target.isEmpty() && number(target, "yaw") > -1.4;
        });
    String target = last("SET_ATTITUDE_TARGET");
    assertThat(number(target, "roll")).isCloseTo(0.2, within(1.0e-6));
    assertThat(number(target, "pitch")).isCloseTo(-0.1, within(1.0e-6));
    assertThat(number(target, "yaw")).as("from the vehicle's -1.5").isBetween(-1.4, -0.99);
    assertThat(number(target, "thrust")).isEqualTo(0.75);
    assertThat(number(target, "type_mask")).as("angles, no rates").isEqualTo(7.0);
    assertThat(number(target, "body_yaw_rate")).isZero();
  }

  @Test
  void heartbeatsEnd_healthSaysSoAndItGoesOnWhenTheyReturn() throws Exception {
    real.with("HEARTBEAT TIMEOUT", 1.5);
    start("tcp");
    real.until(() -> real.latest(Channels.SENSED_STATE).isPresent());
    vehicle.tell("quiet");
    real.until(() -> real.lastError().startsWith("the autopilot "));
    real.forget(Channels.SENSED_STATE);
    vehicle.tell("speak");
    real.until(() -> real.latest(Channels.SENSED_STATE).isPresent());
  }
}
