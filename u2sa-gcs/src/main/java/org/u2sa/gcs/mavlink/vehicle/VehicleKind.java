package org.u2sa.gcs.mavlink.vehicle;

import io.dronefleet.mavlink.minimal.MavType;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** Kinds of vehicles that ground stations distinguish. */
public enum VehicleKind {
  ROVER(MavType.MAV_TYPE_GROUND_ROVER),
  BOAT(MavType.MAV_TYPE_SURFACE_BOAT),
  PLANE(MavType.MAV_TYPE_FIXED_WING),
  COPTER(MavType.MAV_TYPE_QUADROTOR),
  SUBMARINE(MavType.MAV_TYPE_SUBMARINE),
  GENERIC(MavType.MAV_TYPE_GENERIC);

  private final MavType type;

  VehicleKind(MavType type) {
    this.type = type;
  }

  /** MAV_TYPE of its heartbeat. */
  public MavType type() {
    return type;
  }

  /** Whether its altitude follows the ground or the water. */
  public boolean isOnSurface() {
    return this == ROVER || this == BOAT;
  }

  /**
   * Parses a name, such as "rover".
   *
   * @throws IllegalArgumentException if the name is unknown
   */
  public static VehicleKind parse(String text) {
    for (VehicleKind each : values()) {
      if (each.word().equals(text)) {
        return each;
      }
    }
    throw new IllegalArgumentException(
        "\""
            + text
            + "\": expected "
            + Arrays.stream(values()).map(VehicleKind::word).collect(Collectors.joining(", ")));
  }

  private String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Kind of vehicle for a control service's class; GENERIC if it controls several kinds. */
  static VehicleKind ofControl(String className) {
    if (className.startsWith("org.u2sa.control.fixedwing.")) {
      return PLANE;
    }
    return className.startsWith("org.u2sa.control.ground.") ? ROVER : GENERIC;
  }
}
