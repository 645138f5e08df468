package org.u2sa.messages.frame;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The axes of a spatial message (thesis 3.2.3.2). Immutable; encoded as its {@link #name()}.
 *
 * <p>Positive rotations, in all frames except LOCAL_ENU and the BODY frames: phi right wing down,
 * theta nose up, psi clockwise from north.
 */
public final class ReferenceFrame {
  /**
   * WGS-84: x longitude [deg, east +], y latitude [deg, north +], z altitude above mean sea level
   * [m]. Velocities and accelerations are along east, north, up. psi is the true heading [rad,
   * clockwise from north].
   */
  public static final ReferenceFrame GLOBAL = new ReferenceFrame("GLOBAL", 0, true);

  /**
   * Right-handed, x east, y north, z up [m] from a local origin. Attitude is that of FLU axes (ROS
   * REP 103): psi counter-clockwise from east, theta nose DOWN positive, phi right wing down
   * positive.
   */
  public static final ReferenceFrame LOCAL_ENU = new ReferenceFrame("LOCAL_ENU", 0, true);

  /**
   * Right-handed, x north, y east, z down [m] from a local origin. Attitude is that of FRD axes:
   * psi clockwise from north, theta nose up, phi right wing down.
   */
  public static final ReferenceFrame LOCAL_NED = new ReferenceFrame("LOCAL_NED", 0, true);

  /**
   * The thesis's vehicle axes (3.2.3.2): x forward, y left, z down. LEFT-HANDED: convert to {@link
   * #BODY_FRD} before using vector products or rotation matrices. phi positive rolls towards +y
   * (left wing down), theta positive is nose up, psi positive turns from +x to +y (left).
   */
  public static final ReferenceFrame BODY = new ReferenceFrame("BODY", 0, true);

  /**
   * Right-handed vehicle axes x forward, y right, z down: phi right wing down, theta nose up, psi
   * right positive.
   */
  public static final ReferenceFrame BODY_FRD = new ReferenceFrame("BODY_FRD", 0, true);

  /**
   * Right-handed vehicle axes x forward, y left, z up: phi right wing down, theta nose down, psi
   * left positive.
   */
  public static final ReferenceFrame BODY_FLU = new ReferenceFrame("BODY_FLU", 0, true);

  private static final ReferenceFrame[] NAMED = {
    GLOBAL, LOCAL_ENU, LOCAL_NED, BODY, BODY_FRD, BODY_FLU
  };
  private static final Pattern UTM = Pattern.compile("UTM_?(\\d{1,2})_?([NS])");
  private static final int UTM_ZONES = 60;

  private final String name;
  private final int zone;
  private final boolean north;

  private ReferenceFrame(String name, int zone, boolean north) {
    this.name = name;
    this.zone = zone;
    this.north = north;
  }

  /**
   * Universal Transverse Mercator on WGS-84: x easting, y northing [m, false origins included], z
   * altitude above mean sea level [m]; psi clockwise from grid north.
   *
   * @param zone 1…60
   * @param north true for the northern hemisphere's origin
   */
  public static ReferenceFrame utm(int zone, boolean north) {
    if (zone < 1 || zone > UTM_ZONES) {
      throw new IllegalArgumentException("UTM zone: " + zone + " is outside 1…60");
    }
    return new ReferenceFrame("UTM " + zone + (north ? "N" : "S"), zone, north);
  }

  /**
   * Parses a frame's name; case-insensitive, and blanks, hyphens and underscores are equivalent:
   * "Global", "local ned", "UTM 4N".
   *
   * @throws IllegalArgumentException naming the value and what was expected
   */
  public static ReferenceFrame parse(String text) {
    ReferenceFrame exact = named(text); // fast path for the wire form
    return exact != null
        ? exact
        : parsed(text, text.trim().toUpperCase(Locale.ROOT).replaceAll("[ _-]+", "_"));
  }

  private static ReferenceFrame named(String name) {
    for (ReferenceFrame frame : NAMED) {
      if (frame.name.equals(name)) {
        return frame;
      }
    }
    return null;
  }

  private static ReferenceFrame parsed(String text, String key) {
    ReferenceFrame frame = named(key);
    if (frame != null) {
      return frame;
    }
    Matcher utm = UTM.matcher(key);
    if (utm.matches()) {
      return utm(Integer.parseInt(utm.group(1)), "N".equals(utm.group(2)));
    }
    throw new IllegalArgumentException(
        String.format(
            "\"%s\" is not a reference frame; expected GLOBAL, LOCAL_ENU, LOCAL_NED, BODY, BODY_FRD, BODY_FLU or UTM <zone><N|S>",
            text));
  }

  /** Wire form: "GLOBAL", "LOCAL_ENU", …, "UTM 4N". */
  public String name() {
    return name;
  }

  /** Whether this is UTM of any zone. */
  public boolean isUtm() {
    return zone != 0;
  }

  /** UTM zone 1…60; 0 if not UTM. */
  public int zone() {
    return zone;
  }

  /** True unless UTM of the southern hemisphere. */
  public boolean isNorth() {
    return north;
  }

  /** Whether this is a geographic frame: GLOBAL or UTM. */
  public boolean isEarth() {
    return equals(GLOBAL) || isUtm();
  }

  /** Whether this is LOCAL_ENU or LOCAL_NED. */
  public boolean isLocal() {
    return equals(LOCAL_ENU) || equals(LOCAL_NED);
  }

  /** Whether this frame moves with the vehicle. */
  public boolean isBody() {
    return equals(BODY) || equals(BODY_FRD) || equals(BODY_FLU);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ReferenceFrame that && name.equals(that.name);
  }

  @Override
  public int hashCode() {
    return name.hashCode();
  }

  @Override
  public String toString() {
    return name;
  }
}
