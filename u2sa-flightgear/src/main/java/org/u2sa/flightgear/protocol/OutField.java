package org.u2sa.flightgear.protocol;

/**
 * Fields sent by FlightGear, in line order. Values of an {@link OutLine} are in SI units and
 * radians, longitude and latitude in degrees; axes and signs are FlightGear's, as measured with its
 * c172p (docs/flightgear.md).
 */
public enum OutField {
  /** Simulated time [s]; 0 until the flight model runs. */
  ELAPSED("/sim/time/elapsed-sec", Unit.SECOND, 0.0, 1e7),
  /** WGS-84, geodetic [°]. */
  LATITUDE("/position/latitude-deg", Unit.DEGREE_OF_EARTH, -90.0, 90.0),
  /** WGS-84 [°]. */
  LONGITUDE("/position/longitude-deg", Unit.DEGREE_OF_EARTH, -180.0, 180.0),
  /** Reference point above mean sea level [m]. */
  ALTITUDE("/position/altitude-ft", Unit.FOOT, -1_500.0, 60_000.0),
  /** Reference point above the ground below [m]; see {@link OutLine#STANDING_M}. */
  HEIGHT("/position/altitude-agl-ft", Unit.FOOT, -1_000.0, 60_000.0),
  /** Right wing down positive [rad]. */
  ROLL("/orientation/roll-deg", Unit.DEGREE, -180.0, 180.0),
  /** Nose up positive [rad]. */
  PITCH("/orientation/pitch-deg", Unit.DEGREE, -90.0, 90.0),
  /** True heading [rad, 0…2π]. */
  HEADING("/orientation/heading-deg", Unit.DEGREE, 0.0, 360.0),
  /** Rate of the roll angle, not p [rad/s]. */
  ROLL_RATE("/orientation/roll-rate-degps", Unit.DEGREE_PER_SECOND, -3_600.0, 3_600.0),
  /** Rate of the pitch angle, not q [rad/s]. */
  PITCH_RATE("/orientation/pitch-rate-degps", Unit.DEGREE_PER_SECOND, -3_600.0, 3_600.0),
  /** Rate of the heading, not r; right turn positive [rad/s]. */
  HEADING_RATE("/orientation/yaw-rate-degps", Unit.DEGREE_PER_SECOND, -36_000.0, 36_000.0),
  /** Over ground [m/s]. */
  SPEED_NORTH("/velocities/speed-north-fps", Unit.FOOT_PER_SECOND, -2_000.0, 2_000.0),
  /** Over ground [m/s]. */
  SPEED_EAST("/velocities/speed-east-fps", Unit.FOOT_PER_SECOND, -2_000.0, 2_000.0),
  /** Downwards positive [m/s]. */
  SPEED_DOWN("/velocities/speed-down-fps", Unit.FOOT_PER_SECOND, -2_000.0, 2_000.0),
  /** Calibrated [m/s]. */
  CALIBRATED_AIRSPEED("/velocities/airspeed-kt", Unit.KNOT, -100.0, 1_000.0),
  /** Through the air, along the body's forward axis [m/s]. */
  AIR_FORWARD("/fdm/jsbsim/velocities/u-aero-fps", Unit.FOOT_PER_SECOND, -2_000.0, 2_000.0),
  /** Through the air, along the body's right axis [m/s]. */
  AIR_RIGHT("/fdm/jsbsim/velocities/v-aero-fps", Unit.FOOT_PER_SECOND, -2_000.0, 2_000.0),
  /** Through the air, along the body's down axis [m/s]. */
  AIR_DOWN("/fdm/jsbsim/velocities/w-aero-fps", Unit.FOOT_PER_SECOND, -2_000.0, 2_000.0),
  /** Engine speed [1/min]. */
  ENGINE_SPEED("/engines/engine[0]/rpm", Unit.PER_MINUTE, -100.0, 10_000.0),
  /** 1 if the left main wheel carries load; 0 or 1. */
  WEIGHT_ON_WHEEL("/gear/gear[1]/wow", Unit.NONE, 0.0, 1.0),
  /** 1 while the engine is being started; 0 or 1. */
  PRIMER("/controls/engines/engine[0]/use-primer", Unit.NONE, 0.0, 1.0),
  /** 1 if FlightGear reports a crash; its c172p never does. */
  CRASHED("/sim/crashed", Unit.NONE, 0.0, 1.0),
  /** {@link InField#COUNT} as FlightGear received it last: shows that it listens. */
  COUNT(InField.COUNT.node(), Unit.NONE, 0.0, 1e9);

  private final String node;
  private final Unit unit;
  private final double lowest;
  private final double highest;

  OutField(String node, Unit unit, double lowest, double highest) {
    this.node = node;
    this.unit = unit;
    this.lowest = lowest;
    this.highest = highest;
  }

  /** Path in FlightGear's property tree. */
  public String node() {
    return node;
  }

  Unit unit() {
    return unit;
  }

  /** Whether a number of a line, in FlightGear's unit, is plausible. */
  boolean isPlausible(double onTheLine) {
    return onTheLine >= lowest && onTheLine <= highest;
  }

  String range() {
    return lowest + "…" + highest + (unit.symbol().isEmpty() ? "" : " " + unit.symbol());
  }
}
