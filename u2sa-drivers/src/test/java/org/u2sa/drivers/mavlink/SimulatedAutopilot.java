package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.testkit.ServiceKit;

/** An autopilot in simulated time. */
abstract class SimulatedAutopilot {
  final ServiceKit kit = new ServiceKit();
  final MemoryLink link = new MemoryLink();
  final MavlinkStream vehicle = new MavlinkStream(7, 1);
  final List<Object> heard = new ArrayList<>(); // by the vehicle
  boolean speaks = true;
  MavlinkAutopilot service;

  @AfterEach
  void end() {
    kit.close();
  }

  void start() {
    link.with(this::hear);
    service = kit.start(context -> new MavlinkAutopilot(context, link));
    live(1.0);
  }

  void hear(byte[] bytes) {
    vehicle.accept(bytes, bytes.length, each -> heard.add(each.payload()));
  }

  void say(Object message) {
    link.fromDevice(vehicle.encode(message));
  }

  /** Lets time pass, with heartbeats twice a second. */
  void live(double seconds) {
    for (double s = 0.0; s < seconds - 1.0e-9; s += 0.5) {
      if (speaks) {
        say(heartbeat(MavState.MAV_STATE_ACTIVE));
      }
      kit.advance(Math.min(0.5, seconds - s));
    }
  }

  static Heartbeat heartbeat(MavState state) {
    return Heartbeat.builder()
        .type(MavType.MAV_TYPE_GROUND_ROVER)
        .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
        .baseMode(EnumValue.create(129))
        .systemStatus(state)
        .mavlinkVersion(3)
        .build();
  }

  static Attitude attitude(double pitch, double yaw) {
    return Attitude.builder()
        .roll(0.1f)
        .pitch((float) pitch)
        .yaw((float) yaw)
        .rollspeed(0.01f)
        .pitchspeed(0.02f)
        .yawspeed(0.03f)
        .build();
  }

  void command(String actuator, double percent) {
    command(actuator, percent, 0.5);
  }

  void command(String actuator, double percent, double expiryS) {
    kit.publish(Channels.ACTUATION, PercentageCommand.of(actuator, percent).expiry(expiryS));
  }

  <T> List<T> heard(Class<T> type) {
    List<T> all = new ArrayList<>();
    heard.stream().filter(type::isInstance).map(type::cast).forEach(all::add);
    return all;
  }

  <T> T last(Class<T> type) {
    List<T> all = heard(type);
    assertThat(all).as(type.getSimpleName()).isNotEmpty();
    return all.get(all.size() - 1);
  }

  /** The newest with that number. */
  StateInformation state(StateField field) {
    return kit.published(Channels.SENSED_STATE).stream()
        .filter(state -> state.number(field).isPresent())
        .reduce((first, second) -> second)
        .orElseThrow();
  }

  void rc() {
    kit.with("COMMANDS", "rc")
        .with("CHANNEL 1 ACTUATOR", "STEERING")
        .with("CHANNEL 3 ACTUATOR", "THROTTLE")
        .with("CHANNEL 3 ONE WAY", true);
    start();
  }

  void stop() {
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().operator("the test").reason("test").active(true).stopId("a"));
  }

  /** Lets time pass with heartbeats to a successor's link. */
  void live(MemoryLink to, double seconds) {
    for (double s = 0.0; s < seconds - 1.0e-9; s += 0.1) {
      to.fromDevice(vehicle.encode(heartbeat(MavState.MAV_STATE_ACTIVE)));
      kit.advance(0.1);
    }
  }

  /** The steering pulses that the vehicle heard, without repetitions. */
  List<Integer> steering() {
    List<Integer> all = new ArrayList<>();
    for (RcChannelsOverride each : heard(RcChannelsOverride.class)) {
      if (all.isEmpty() || all.get(all.size() - 1) != each.chan1Raw()) {
        all.add(each.chan1Raw());
      }
    }
    return all;
  }

  long steeringCount(int pulse) {
    return heard(RcChannelsOverride.class).stream().filter(e -> e.chan1Raw() == pulse).count();
  }

  /** What is left of the actuators, by their newest announcements [%]. */
  List<Double> left() {
    Map<String, Double> left = new TreeMap<>();
    kit.published(Channels.ACTUATORS)
        .forEach(each -> left.put(each.actuatorName(), each.available().orElse(100.0)));
    return List.copyOf(left.values());
  }
}
