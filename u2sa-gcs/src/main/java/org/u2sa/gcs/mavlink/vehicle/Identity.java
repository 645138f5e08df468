package org.u2sa.gcs.mavlink.vehicle;

import io.dronefleet.mavlink.minimal.MavAutopilot;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The autopilot that the vehicle presents to stations. It determines their buttons and conventions:
 * mode numbers, parameter encoding, home as mission item 0.
 */
public enum Identity {
  PX4(MavAutopilot.MAV_AUTOPILOT_PX4),
  ARDUPILOT(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA),
  GENERIC(MavAutopilot.MAV_AUTOPILOT_GENERIC);

  private static final int PX4_EXTERNAL = 11; // sub mode of PX4's first external mode
  private static final long FIRST_PLANNER = 100; // beyond all modes of ArduPilot
  private static final int PX4_AUTO = 4; // px4_custom_mode.h: main mode in byte 2, sub mode in 3
  private static final int PX4_MAIN_SHIFT = 16;
  private static final int PX4_SUB_SHIFT = 24;

  private final MavAutopilot autopilot;

  Identity(MavAutopilot autopilot) {
    this.autopilot = autopilot;
  }

  /** MAV_AUTOPILOT of the heartbeat. */
  public MavAutopilot autopilot() {
    return autopilot;
  }

  /** Whether integer parameters are sent as numbers cast to float instead of as raw bits. */
  public boolean castsParameters() {
    return this == ARDUPILOT;
  }

  /** Whether altitudes of COMMAND_LONG, which names no frame, are above home. */
  public boolean commandsAboveHome() {
    return this == ARDUPILOT;
  }

  /** Whether item 0 of a mission is the home position. */
  public boolean startsWithHome() {
    return this == ARDUPILOT;
  }

  /**
   * Parses a name, such as "px4".
   *
   * @throws IllegalArgumentException if the name is unknown
   */
  public static Identity parse(String text) {
    for (Identity each : values()) {
      if (each.name().toLowerCase(Locale.ROOT).equals(text)) {
        return each;
      }
    }
    throw new IllegalArgumentException("\"" + text + "\": expected px4, ardupilot or generic");
  }

  /** Custom mode of each mode of the vehicle that has one. */
  public Map<VehicleMode, Long> modes(VehicleKind kind) {
    Map<VehicleMode, Long> modes = new EnumMap<>(VehicleMode.class);
    if (this == PX4) {
      modes.put(VehicleMode.HOLD, px4(3));
      modes.put(VehicleMode.MISSION, px4(4));
      modes.put(VehicleMode.RETURN, px4(5));
      modes.put(VehicleMode.LAND, px4(6));
      modes.put(VehicleMode.GO_TO, px4(3)); // as in PX4, go-to is Hold at another place
      modes.put(VehicleMode.MANUAL, 1L << PX4_MAIN_SHIFT);
    } else if (this == ARDUPILOT) {
      boolean isCopter = kind == VehicleKind.COPTER;
      boolean dives = kind == VehicleKind.SUBMARINE;
      modes.put(VehicleMode.MISSION, isCopter || dives ? 3L : 10L);
      modes.put(VehicleMode.GO_TO, isCopter || dives ? 4L : 15L);
      modes.put(VehicleMode.RETURN, isCopter ? 6L : 11L);
      modes.put(VehicleMode.LAND, isCopter || dives ? 9L : 11L);
      modes.put(VehicleMode.MANUAL, dives ? 19L : 0L);
      modes.put(
          VehicleMode.HOLD, isCopter ? 5L : dives ? 16L : kind == VehicleKind.PLANE ? 12L : 4L);
    } else {
      for (VehicleMode each : VehicleMode.values()) {
        modes.put(each, (long) each.ordinal());
      }
    }
    return modes;
  }

  /** Custom mode of another Path Planner class, by its index from 0. */
  public long planner(int index) {
    return this == PX4 ? px4(PX4_EXTERNAL + index) : FIRST_PLANNER + index;
  }

  /** Index of the class of a custom mode; empty if it has none. */
  public Optional<Integer> planner(long custom, PlannerModes planners) {
    return IntStream.range(0, planners.size())
        .filter(index -> planner(index) == custom)
        .boxed()
        .findFirst();
  }

  private static long px4(int sub) {
    return (long) PX4_AUTO << PX4_MAIN_SHIFT | (long) sub << PX4_SUB_SHIFT;
  }

  /** The mode with this custom mode number; empty if the vehicle has no such mode. */
  public Optional<VehicleMode> mode(long custom, VehicleKind kind) {
    return modes(kind).entrySet().stream()
        .filter(each -> each.getValue() == custom && each.getKey() != VehicleMode.GO_TO)
        .map(Map.Entry::getKey)
        .findFirst();
  }

  /** Custom mode of PX4's main and sub mode, as MAV_CMD_DO_SET_MODE names them. */
  public long custom(float second, float third) {
    long main = (long) second;
    return this == PX4
        ? (main << PX4_MAIN_SHIFT | (long) third << PX4_SUB_SHIFT) & 0xFFFF_FFFFL
        : main;
  }
}
