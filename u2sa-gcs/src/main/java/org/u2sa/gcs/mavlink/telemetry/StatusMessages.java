package org.u2sa.gcs.mavlink.telemetry;

import io.dronefleet.mavlink.common.ExtendedSysState;
import io.dronefleet.mavlink.common.HomePosition;
import io.dronefleet.mavlink.common.MavLandedState;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.MavVtolState;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.common.SystemTime;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.mavlink.AvailableModes;
import org.u2sa.mavlink.AvailableModesMonitor;
import org.u2sa.mavlink.CurrentMode;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FenceState;

/** Messages about modes, readiness, battery and home. */
final class StatusMessages {
  private static final int MAVLINK_VERSION = 3;
  private static final double E7 = 1.0e7;
  private static final double MILLI = 1000.0;
  private static final int NOT_SELECTABLE = 2; // MAV_MODE_PROPERTY_NOT_USER_SELECTABLE

  private final VehicleStatus vehicle;
  private final Identity identity;
  private final Placement placement;
  private final Uptime uptime;

  StatusMessages(VehicleStatus vehicle, Identity identity, Placement placement, Uptime uptime) {
    this.vehicle = vehicle;
    this.identity = identity;
    this.placement = placement;
    this.uptime = uptime;
  }

  Optional<Object> heartbeat() {
    boolean armed = vehicle.isArmed();
    VehicleMode mode = vehicle.mode();
    int flags =
        flag(MavModeFlag.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED)
            | flag(MavModeFlag.MAV_MODE_FLAG_STABILIZE_ENABLED)
            | flag(MavModeFlag.MAV_MODE_FLAG_GUIDED_ENABLED)
            | flag(MavModeFlag.MAV_MODE_FLAG_AUTO_ENABLED)
            | (mode == VehicleMode.MANUAL
                ? flag(MavModeFlag.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED)
                : 0)
            | (armed ? flag(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED) : 0);
    return Optional.of(
        Heartbeat.builder()
            .type(vehicle.kind().type())
            .autopilot(identity.autopilot())
            .baseMode(EnumValue.create(MavModeFlag.class, flags))
            .customMode(custom(mode))
            .systemStatus(condition(armed))
            .mavlinkVersion(MAVLINK_VERSION)
            .build());
  }

  private static int flag(MavModeFlag flag) {
    return EnumValue.of(flag).value();
  }

  /** While the mission is pursued, each other planner class is a separate mode. */
  private long custom(VehicleMode mode) {
    Optional<Integer> planner = vehicle.planners().running();
    if (mode == VehicleMode.MISSION && planner.isPresent()) {
      return identity.planner(planner.get());
    }
    return identity.modes(vehicle.kind()).get(mode);
  }

  private MavState condition(boolean armed) {
    if (vehicle.isStopped()) {
      return MavState.MAV_STATE_EMERGENCY;
    }
    if (vehicle.failsafe() != FailsafeAction.CONTINUE) {
      return MavState.MAV_STATE_CRITICAL;
    }
    return armed ? MavState.MAV_STATE_ACTIVE : MavState.MAV_STATE_STANDBY;
  }

  Optional<Object> currentMode() {
    VehicleMode mode = vehicle.mode();
    return Optional.of(new CurrentMode(mode.standard(), custom(mode), 0));
  }

  /** AVAILABLE_MODES at an index from 1; empty beyond the last. */
  Optional<Object> mode(int index) {
    Map<VehicleMode, Long> modes = identity.modes(vehicle.kind());
    List<VehicleMode> listed =
        modes.keySet().stream()
            .filter(mode -> identity != Identity.PX4 || mode != VehicleMode.GO_TO)
            .toList();
    int planner = index - listed.size() - 1;
    if (index < 1 || planner >= vehicle.planners().size()) {
      return Optional.empty();
    }
    if (planner >= 0) {
      String label = vehicle.planners().label(planner);
      return Optional.of(
          new AvailableModes(modes(), index, 0, identity.planner(planner), 0, label));
    }
    VehicleMode mode = listed.get(index - 1);
    long properties = mode == VehicleMode.GO_TO ? NOT_SELECTABLE : 0;
    return Optional.of(
        new AvailableModes(
            modes(), index, mode.standard(), modes.get(mode), properties, mode.label()));
  }

  int modes() {
    return identity.modes(vehicle.kind()).size()
        - (identity == Identity.PX4 ? 1 : 0)
        + vehicle.planners().size();
  }

  Optional<Object> modesMonitor() {
    return Optional.of(new AvailableModesMonitor(vehicle.planners().version() & 0xFF));
  }

  Optional<Object> systemStatus() {
    boolean positioned = placement.local().isPresent();
    boolean ready = vehicle.isArmed() || vehicle.reasonsAgainstArming().isEmpty();
    int always =
        bit(MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK)
            | bit(MavSysStatusSensor.MAV_SYS_STATUS_AHRS)
            | bit(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_GPS)
            | (vehicle.battery().isPresent()
                ? bit(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY)
                : 0)
            | (vehicle.fence().flatMap(FenceState::file).isPresent()
                ? bit(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE)
                : 0);
    int healthy =
        (ready ? bit(MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK) : 0)
            | (positioned ? bit(MavSysStatusSensor.MAV_SYS_STATUS_AHRS) : 0)
            | (placement.global().isPresent()
                ? bit(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_GPS)
                : 0)
            | (isInsideFence() ? bit(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE) : 0)
            | always & bit(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY);
    Optional<BatteryState> battery = vehicle.battery();
    return Optional.of(
        SysStatus.builder()
            .onboardControlSensorsPresent(EnumValue.create(MavSysStatusSensor.class, always))
            .onboardControlSensorsEnabled(EnumValue.create(MavSysStatusSensor.class, always))
            .onboardControlSensorsHealth(EnumValue.create(MavSysStatusSensor.class, healthy))
            .voltageBattery(BatteryMessages.millivolts(battery))
            .currentBattery(BatteryMessages.centiamperes(battery))
            .batteryRemaining(BatteryMessages.percent(battery))
            .build());
  }

  /** Stations treat an unhealthy fence as a breach. */
  private boolean isInsideFence() {
    return vehicle.failsafeCauses().stream().noneMatch(cause -> cause.contains("fence"));
  }

  private static int bit(MavSysStatusSensor sensor) {
    return EnumValue.of(sensor).value();
  }

  Optional<Object> extendedState() {
    Optional<AircraftState> aircraft =
        vehicle.state().filter(AircraftState.class::isInstance).map(AircraftState.class::cast);
    MavLandedState landed =
        aircraft
            .map(
                state ->
                    state.weightOnWheels()
                        ? MavLandedState.MAV_LANDED_STATE_ON_GROUND
                        : MavLandedState.MAV_LANDED_STATE_IN_AIR)
            .orElse(
                vehicle.kind().isOnSurface()
                    ? MavLandedState.MAV_LANDED_STATE_ON_GROUND
                    : MavLandedState.MAV_LANDED_STATE_UNDEFINED);
    return Optional.of(
        ExtendedSysState.builder()
            .vtolState(MavVtolState.MAV_VTOL_STATE_UNDEFINED)
            .landedState(landed)
            .build());
  }

  Optional<Object> systemTime() {
    return Optional.of(
        SystemTime.builder()
            .timeUnixUsec(BigInteger.valueOf(uptime.unixMicros()))
            .timeBootMs(uptime.millis())
            .build());
  }

  Optional<Object> home() {
    return placement
        .home()
        .map(
            place ->
                HomePosition.builder()
                    .latitude(MotionMessages.scaled(place.latitudeDeg(), E7))
                    .longitude(MotionMessages.scaled(place.longitudeDeg(), E7))
                    .altitude(MotionMessages.scaled(place.altitudeM(), MILLI))
                    .q(List.of(1.0f, 0.0f, 0.0f, 0.0f))
                    .approachX(Float.NaN)
                    .approachY(Float.NaN)
                    .approachZ(Float.NaN)
                    .timeUsec(BigInteger.valueOf(uptime.micros()))
                    .build());
  }
}
