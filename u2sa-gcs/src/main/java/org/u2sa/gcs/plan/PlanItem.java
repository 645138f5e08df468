package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * One mission item in MAVLink's form (MISSION_ITEM, mavlink.io/en/messages/common.html).
 *
 * @param command number of its MAV_CMD
 * @param frame number of its MAV_FRAME
 * @param parameters seven numbers, as the command defines them; NaN where empty
 * @param goesOn whether the next item follows automatically
 * @param id number by which jumps name it
 */
public record PlanItem(int command, int frame, List<Double> parameters, boolean goesOn, int id) {
  public static final int WAYPOINT = 16;
  public static final int LOITER_UNLIMITED = 17;
  public static final int LOITER_TURNS = 18;
  public static final int LOITER_TIME = 19;
  static final int RETURN = 20;
  public static final int LAND = 21;
  public static final int TAKE_OFF = 22;
  static final int LOITER_TO_ALTITUDE = 31;
  static final int DELAY = 93;
  public static final int JUMP = 177;
  static final int CHANGE_SPEED = 178;
  static final int LAND_START = 189;
  static final int VIEW = 195;
  static final int NO_VIEW = 197;
  static final int ANY_VIEW = 201;
  static final int IMAGE_DISTANCE = 206;

  public static final int GLOBAL = 0;
  static final int MISSION = 2; // no coordinates
  public static final int RELATIVE = 3;
  static final int GLOBAL_INT = 5;
  static final int RELATIVE_INT = 6;

  public static final int PARAMETERS = 7;

  private static final int HEADING = 4; // its parameter
  private static final double NORTH_DEG = 360.0;

  private static final Set<Integer> ORDERS =
      Set.of(JUMP, CHANGE_SPEED, RETURN, DELAY, LAND_START, NO_VIEW, IMAGE_DISTANCE);
  private static final Map<Integer, String> NAMES =
      Map.ofEntries(
          Map.entry(WAYPOINT, "NAV_WAYPOINT"),
          Map.entry(LOITER_UNLIMITED, "NAV_LOITER_UNLIM"),
          Map.entry(LOITER_TURNS, "NAV_LOITER_TURNS"),
          Map.entry(LOITER_TIME, "NAV_LOITER_TIME"),
          Map.entry(RETURN, "NAV_RETURN_TO_LAUNCH"),
          Map.entry(LAND, "NAV_LAND"),
          Map.entry(TAKE_OFF, "NAV_TAKEOFF"),
          Map.entry(LOITER_TO_ALTITUDE, "NAV_LOITER_TO_ALT"),
          Map.entry(82, "NAV_SPLINE_WAYPOINT"),
          Map.entry(84, "NAV_VTOL_TAKEOFF"),
          Map.entry(85, "NAV_VTOL_LAND"),
          Map.entry(DELAY, "NAV_DELAY"),
          Map.entry(112, "CONDITION_DELAY"),
          Map.entry(115, "CONDITION_YAW"),
          Map.entry(JUMP, "DO_JUMP"),
          Map.entry(CHANGE_SPEED, "DO_CHANGE_SPEED"),
          Map.entry(179, "DO_SET_HOME"),
          Map.entry(181, "DO_SET_RELAY"),
          Map.entry(183, "DO_SET_SERVO"),
          Map.entry(LAND_START, "DO_LAND_START"),
          Map.entry(VIEW, "DO_SET_ROI_LOCATION"),
          Map.entry(NO_VIEW, "DO_SET_ROI_NONE"),
          Map.entry(ANY_VIEW, "DO_SET_ROI"),
          Map.entry(203, "DO_DIGICAM_CONTROL"),
          Map.entry(205, "DO_MOUNT_CONTROL"),
          Map.entry(IMAGE_DISTANCE, "DO_SET_CAM_TRIGG_DIST"),
          Map.entry(530, "SET_CAMERA_MODE"),
          Map.entry(2000, "IMAGE_START_CAPTURE"),
          Map.entry(2001, "IMAGE_STOP_CAPTURE"));

  public PlanItem {
    parameters = List.copyOf(parameters);
  }

  /** An item without coordinates. */
  static PlanItem order(int id, int command, double... first) {
    return of(id, command, MISSION, List.of(), first);
  }

  /** An item at a position: latitude, longitude [deg], altitude [m]. */
  public static PlanItem at(int id, int command, int frame, List<Double> place, double... first) {
    return of(id, command, frame, place, first);
  }

  private static PlanItem of(int id, int command, int frame, List<Double> place, double... first) {
    Double[] all = new Double[PARAMETERS];
    for (int i = 0; i < PARAMETERS; i++) {
      int ofPlace = i - (PARAMETERS - place.size());
      all[i] = i < first.length ? Double.valueOf(first[i]) : ofPlace < 0 ? 0.0 : place.get(ofPlace);
    }
    return new PlanItem(command, frame, List.of(all), true, id);
  }

  /**
   * @param number from 1, as in the documentation of commands
   */
  public double parameter(int number) {
    return parameters.get(number - 1);
  }

  /** Copy with a different value of a parameter, counted from 1. */
  public PlanItem with(int number, double value) {
    List<Double> changed = new ArrayList<>(parameters);
    changed.set(number - 1, value);
    return new PlanItem(command, frame, changed, goesOn, id);
  }

  /** Whether it has no coordinates. */
  public boolean isOrder() {
    return ORDERS.contains(command);
  }

  /** Whether its position is a point to look at rather than a destination. */
  public boolean isView() {
    return command == VIEW || command == ANY_VIEW;
  }

  private boolean hasHeading() {
    return !isOrder() && !isView();
  }

  /** For items from a writer that stores an empty heading as 0. */
  public PlanItem withoutHeading0() {
    return hasHeading() && parameter(HEADING) == 0.0 ? with(HEADING, Double.NaN) : this;
  }

  /** For a reader that treats a heading of 0 as none: north becomes 360. */
  public PlanItem withNorth360() {
    return hasHeading() && parameter(HEADING) == 0.0 ? with(HEADING, NORTH_DEG) : this;
  }

  /** Number and command, for messages. */
  public String title() {
    String name = NAMES.get(command);
    return "item " + id + " (" + (name == null ? "command " + command : "MAV_CMD_" + name) + ")";
  }
}
