package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.SystemClock;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.service.ServiceContext;

/** The outside judge: pymavlink plays the vehicle, over TCP and UDP, in real time. */
class PymavlinkTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String SYSTEM_ID = "judged";

  @TempDir Path logs;

  private final SystemClock clock = new SystemClock();
  private final LocalBus bus = new LocalBus(SYSTEM_ID);
  private final Map<String, U2SAData> latest = new ConcurrentHashMap<>(); // by channel
  private final Map<String, Object> variables = new HashMap<>();
  private PymavlinkVehicle vehicle;
  private MavlinkAutopilot service;

  private void start(String kind) throws Exception {
    vehicle = PymavlinkVehicle.start(kind);
    bus.attach((channel, message) -> latest.put(channel.name(), message));
    variables.put("CONNECTION", kind + ":127.0.0.1:" + vehicle.port());
    service =
        new MavlinkAutopilot(
            ServiceContext.of(SYSTEM_ID, XmlConfiguration.inMemory("the test", variables))
                .clock(clock)
                .transport(bus)
                .logDirectory(logs)
                .build());
    service.start();
  }

  @AfterEach
  void end() throws Exception {
    if (service != null) {
      service.kill();
    }
    if (vehicle != null) {
      vehicle.close();
    }
  }

  private static void until(Callable<Boolean> condition) {
    await().atMost(PATIENCE).pollInterval(Duration.ofMillis(50)).until(condition);
  }

  private <T extends U2SAData> Optional<T> latest(Channel<T> channel) {
    return Optional.ofNullable(latest.get(channel.name())).map(channel.type().messageClass()::cast);
  }

  private void command(String actuator, double percent) {
    PercentageCommand command = PercentageCommand.of(actuator, percent);
    command.systemId(SYSTEM_ID);
    command.timestamp(clock.micros());
    command.freeze();
    bus.deliver(Channels.ACTUATION, command);
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
    until(() -> latest(Channels.SENSED_STATE).flatMap(s -> optional(s)).isPresent());
    StateInformation state = latest(Channels.SENSED_STATE).orElseThrow();
    assertThat(state.y().getAsDouble()).isCloseTo(47.397742, within(1.0e-9));
    assertThat(state.x().getAsDouble()).isCloseTo(8.545594, within(1.0e-9));
    assertThat(state.z()).hasValue(488.1);
    assertThat(state.xDot()).hasValue(2.0);
    assertThat(state.yDot()).hasValue(1.0);
    assertThat(state.zDot()).hasValue(-0.5);
    assertThat(state.phi().getAsDouble()).isCloseTo(0.1, within(1.0e-6));
    assertThat(state.theta().getAsDouble()).isCloseTo(-0.2, within(1.0e-6));
    assertThat(state.psi().getAsDouble()).isCloseTo(2.0 * Math.PI - 1.5, within(1.0e-6));
    assertThat(state.xSigma()).hasValue(0.8);
    until(() -> latest(Channels.POWER).isPresent());
    BatteryState battery = latest(Channels.POWER).orElseThrow();
    assertThat(battery.voltage().getAsDouble()).isCloseTo(15.2, within(1.0e-9));
    assertThat(battery.current().getAsDouble()).isCloseTo(12.3, within(1.0e-9));
    assertThat(battery.remaining()).hasValue(64.0);

    until(() -> vehicle.heard("HEARTBEAT").size() >= 2);
    String heartbeat = last("HEARTBEAT");
    assertThat(heartbeat).contains("\"from\": [255, 191]");
    assertThat(number(heartbeat, "type")).as("onboard controller").isEqualTo(18.0);
    assertThat(number(heartbeat, "autopilot")).as("none").isEqualTo(8.0);
    assertThat(vehicle.heard("BAD_DATA")).isEmpty();
  }

  /** With position and errors. */
  private static Optional<StateInformation> optional(StateInformation state) {
    return state.x().isPresent() && state.xSigma().isPresent()
        ? Optional.of(state)
        : Optional.empty();
  }

  @Test
  void commandsToRadioChannels_overrideNeutralAndGiveBack() throws Exception {
    variables.put("COMMANDS", "rc");
    variables.put("CHANNEL 1 ACTUATOR", "STEERING");
    variables.put("CHANNEL 3 ACTUATOR", "THROTTLE");
    variables.put("NEUTRAL TIME", 0.5);
    start("tcp");
    until(
        () -> {
          command("STEERING", 50.0);
          command("THROTTLE", -20.0);
          String override = last("RC_CHANNELS_OVERRIDE");
          return !override.isEmpty() && number(override, "chan3_raw") == 1400.0;
        });
    String override = last("RC_CHANNELS_OVERRIDE");
    assertThat(number(override, "chan1_raw")).isEqualTo(1750.0);
    assertThat(number(override, "chan2_raw")).as("ignore").isEqualTo(65535.0);
    assertThat(number(override, "target_system")).isEqualTo(7.0);
    assertThat(number(override, "target_component")).isEqualTo(1.0);

    until(() -> number(last("RC_CHANNELS_OVERRIDE"), "chan1_raw") == 0.0);
    assertThat(number(last("RC_CHANNELS_OVERRIDE"), "chan3_raw")).as("given back").isZero();
    assertThat(vehicle.heard("RC_CHANNELS_OVERRIDE"))
        .as("neutral before")
        .anySatisfy(each -> assertThat(number(each, "chan1_raw")).isEqualTo(1500.0));
    assertThat(vehicle.heard("BAD_DATA")).isEmpty();
  }

  @Test
  void commandsAsVelocities_untilTheEmergencyStop() throws Exception {
    variables.put("COMMANDS", "velocity");
    start("udp");
    until(
        () -> {
          command("FORWARD SPEED", 50.0);
          command("LEFT SPEED", 20.0);
          command("CLIMB SPEED", 25.0);
          command("TURN RATE", -25.0);
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
    stop.systemId(SYSTEM_ID);
    stop.timestamp(clock.micros());
    stop.freeze();
    bus.deliver(Channels.EMERGENCY_STOP, stop);
    until(() -> number(last("SET_POSITION_TARGET_LOCAL_NED"), "vx") == 0.0);
    assertThat(number(last("SET_POSITION_TARGET_LOCAL_NED"), "yaw_rate")).isZero();
  }

  @Test
  void commandsAsAttitude_anglesArePymavlinks() throws Exception {
    variables.put("COMMANDS", "attitude");
    start("tcp");
    until(
        () -> {
          command("ROLL ANGLE", 40.0);
          command("PITCH ANGLE", -20.0);
          command("YAW RATE", 30.0);
          command("THRUST", 75.0);
          String target = last("SET_ATTITUDE_TARGET");
          return !target.isEmpty() && number(target, "body_yaw_rate") > 0.2;
        });
    String target = last("SET_ATTITUDE_TARGET");
    assertThat(number(target, "roll")).isCloseTo(0.2, within(1.0e-6));
    assertThat(number(target, "pitch")).isCloseTo(-0.1, within(1.0e-6));
    assertThat(number(target, "yaw")).isCloseTo(0.0, within(1.0e-6));
    assertThat(number(target, "thrust")).isEqualTo(0.75);
    assertThat(number(target, "type_mask")).isEqualTo(3.0);
    assertThat(number(target, "body_yaw_rate")).isCloseTo(0.3, within(1.0e-6));
  }

  @Test
  void heartbeatsEnd_healthSaysSoAndItGoesOnWhenTheyReturn() throws Exception {
    variables.put("HEARTBEAT TIMEOUT", 1.5);
    start("tcp");
    until(() -> latest(Channels.SENSED_STATE).isPresent());
    vehicle.tell("quiet");
    until(
        () ->
            latest(Channels.HEALTH)
                .flatMap(HealthReport::lastError)
                .filter(error -> error.startsWith("the autopilot "))
                .isPresent());
    latest.remove(Channels.SENSED_STATE.name());
    vehicle.tell("speak");
    until(() -> latest(Channels.SENSED_STATE).isPresent());
  }
}
