package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.frame.Geodetic;

/**
 * Turns uploaded items into the XML of a mission (docs/missions.md). Goals are named by the index
 * of their item, from 1.
 */
final class PlanReader {
  /** A goal to be written. */
  private static final class Goal {
    private final StringBuilder text = new StringBuilder();
    private String element = "waypoint";
  }

  private static final int SPEED_TYPES = 2; // airspeed, ground speed

  private final VehicleKind kind;
  private final Optional<Geodetic> home;
  private final List<MissionItem> items;
  private final Goal[] goals;
  private float speed; // [m/s]; 0: none

  /**
   * @param home for altitudes relative to it, and to return to
   */
  PlanReader(VehicleKind kind, Optional<Geodetic> home, List<MissionItem> items) {
    this.kind = kind;
    this.home = home;
    this.items = items;
    goals = new Goal[items.size()];
  }

  /**
   * The mission in XML.
   *
   * @throws PlanRefusal if an item cannot be expressed
   */
  String xml() {
    for (int i = 0; i < items.size(); i++) {
      read(i);
    }
    StringBuilder xml = new StringBuilder("<mission>\n");
    home.ifPresent(
        place ->
            xml.append("<home>")
                .append(element("x", place.longitudeDeg()))
                .append(element("y", place.latitudeDeg()))
                .append(element("z", place.altitudeM()))
                .append("</home>\n"));
    for (int i = 0; i < goals.length; i++) {
      Goal goal = goals[i];
      if (goal != null) {
        xml.append('<').append(goal.element).append("><name>").append(name(i)).append("</name>");
        xml.append(goal.text).append("</").append(goal.element).append(">\n");
      }
    }
    if (Arrays.stream(goals).allMatch(goal -> goal == null)) {
      throw new PlanRefusal(
          MavMissionResult.MAV_MISSION_INVALID,
          "the mission has no waypoint; expected at least one");
    }
    return xml.append("</mission>\n").toString();
  }

  /** Name of the goal of each item, as {@link MissionPlan#goals}. */
  List<String> names() {
    List<String> names = new ArrayList<>();
    String following = "";
    for (int i = items.size() - 1; i >= 0; i--) {
      boolean returns = items.get(i).command() == MissionItem.RETURN;
      following = returns ? VehicleStatus.HOME : goals[i] == null ? following : name(i);
      names.add(0, following);
    }
    return names;
  }

  private static String name(int index) {
    return Integer.toString(index + 1);
  }

  private void read(int index) {
    MissionItem item = items.get(index);
    switch (item.command()) {
      case MissionItem.WAYPOINT -> place(index, item.param1());
      case MissionItem.TAKE_OFF -> takeOff(index);
      case MissionItem.LOITER_TIME -> place(index, Math.max(item.param1(), Float.MIN_NORMAL));
      case MissionItem.LOITER_UNLIMITED -> loiter(index);
      case MissionItem.RETURN -> returnHome(index);
      case MissionItem.CHANGE_SPEED -> changeSpeed(index);
      case MissionItem.JUMP -> jump(index);
      default ->
          throw refusal(
              index, MavMissionResult.MAV_MISSION_UNSUPPORTED, "the command has no equivalent");
    }
  }

  private void takeOff(int index) {
    if (kind.isOnSurface()) {
      throw refusal(
          index, MavMissionResult.MAV_MISSION_UNSUPPORTED, "this vehicle does not take off");
    }
    if (items.get(index).hasPlace()) {
      place(index, 0.0f);
    } else {
      Goal goal = new Goal();
      goals[index] = goal;
      goal.text.append(element("z", altitude(index))).append(element("verticalThreshold", 10.0));
    }
  }

  private void loiter(int index) {
    if (index < items.size() - 1) {
      throw refusal(
          index, MavMissionResult.MAV_MISSION_UNSUPPORTED, "expected as the last item only");
    }
    place(index, 0.0f);
  }

  private void place(int index, float holdS) {
    MissionItem item = items.get(index);
    if (Float.isInfinite(item.param2()) || Float.isInfinite(holdS)) {
      throw refusal(
          index, MavMissionResult.MAV_MISSION_INVALID, "a radius or time without end is none");
    }
    if (!item.hasPlace()) {
      throw refusal(
          index, MavMissionResult.MAV_MISSION_INVALID_PARAM5_X, "it has no latitude and longitude");
    }
    Goal goal = new Goal();
    goals[index] = goal;
    goal.text.append(element("x", item.longitudeDeg())).append(element("y", item.latitudeDeg()));
    double altitudeM = altitude(index);
    if (!kind.isOnSurface()) {
      goal.text.append(element("z", altitudeM));
    }
    if (item.param2() > 0.0f && item.command() == MissionItem.WAYPOINT) {
      goal.text.append(element("horizontalThreshold", item.param2()));
    }
    boolean hasHeading = Float.isFinite(item.param4()) && item.param4() != 0.0f; // 0: left out
    if (hasHeading && item.command() == MissionItem.WAYPOINT) {
      goal.text.append("<psi unit=\"deg\">").append(plain(item.param4())).append("</psi>");
    }
    if (speed > 0.0f) {
      goal.text.append(element("speed", speed));
    }
    if (holdS > 0.0f) {
      if (kind == VehicleKind.PLANE) {
        throw refusal(
            index,
            MavMissionResult.MAV_MISSION_INVALID_PARAM1,
            "a plane cannot wait at a waypoint");
      }
      goal.element = "station";
      goal.text.append(element("duration", holdS));
    }
  }

  /** Altitude above mean sea level [m]. */
  private double altitude(int index) {
    MissionItem item = items.get(index);
    double z = item.z();
    if (!Double.isFinite(z)) {
      throw refusal(
          index, MavMissionResult.MAV_MISSION_INVALID_PARAM7, "altitude " + z + " is no number");
    }
    return switch (item.frame()) {
      case MissionItem.GLOBAL, MissionItem.GLOBAL_INT -> z;
      case MissionItem.GLOBAL_RELATIVE, MissionItem.GLOBAL_RELATIVE_INT ->
          home.map(place -> place.altitudeM() + z)
              .orElseThrow(
                  () ->
                      refusal(
                          index,
                          MavMissionResult.MAV_MISSION_UNSUPPORTED_FRAME,
                          "its altitude is relative to a home that is not known"));
      default ->
          throw refusal(
              index,
              MavMissionResult.MAV_MISSION_UNSUPPORTED_FRAME,
              "frame " + item.frame() + "; expected GLOBAL or GLOBAL_RELATIVE_ALT");
    };
  }

  private void returnHome(int index) {
    if (index < items.size() - 1 || home.isEmpty()) {
      throw refusal(
          index,
          MavMissionResult.MAV_MISSION_UNSUPPORTED,
          home.isEmpty() ? "no home is known" : "expected as the last item only");
    }
    last(index).text.append("<next if=\"done\">").append(VehicleStatus.HOME).append("</next>");
  }

  private void changeSpeed(int index) {
    MissionItem item = items.get(index);
    boolean isSpeed = item.param1() >= 0.0f && item.param1() < SPEED_TYPES;
    if (!isSpeed || !(item.param2() > 0.0f) || !Float.isFinite(item.param2())) {
      throw refusal(
          index,
          MavMissionResult.MAV_MISSION_INVALID_PARAM2,
          "speed "
              + item.param2()
              + " m/s of type "
              + item.param1()
              + "; expected more than 0 of type 0 or 1");
    }
    speed = item.param2();
  }

  private void jump(int index) {
    MissionItem item = items.get(index);
    int target = (int) item.param1();
    int times = (int) item.param2();
    String expected = "jump to item " + item.param1() + ", " + item.param2() + " times; expected ";
    if (target < 0 || target >= index || goals[target] == null) {
      throw refusal(
          index, MavMissionResult.MAV_MISSION_INVALID_PARAM1, expected + "a waypoint before it");
    }
    if (times < 1) {
      throw refusal(index, MavMissionResult.MAV_MISSION_INVALID_PARAM2, expected + "at least once");
    }
    last(index)
        .text
        .append(String.format("<repeat from=\"%s\" times=\"%d\"/>", name(target), times));
  }

  private Goal last(int index) {
    for (int i = index - 1; i >= 0; i--) {
      if (goals[i] != null) {
        return goals[i];
      }
    }
    throw refusal(index, MavMissionResult.MAV_MISSION_INVALID, "expected a waypoint before it");
  }

  private PlanRefusal refusal(int index, MavMissionResult result, String why) {
    return new PlanRefusal(
        result, "mission item " + index + " (MAV_CMD " + items.get(index).command() + "): " + why);
  }

  private static String element(String name, double value) {
    return "<" + name + ">" + plain(value) + "</" + name + ">";
  }

  private static String plain(double value) {
    return BigDecimal.valueOf(value).toPlainString();
  }
}
