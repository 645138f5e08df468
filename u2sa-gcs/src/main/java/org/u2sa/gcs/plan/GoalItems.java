package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.FieldValue;

/**
 * Goals as items: a waypoint is NAV_WAYPOINT with its threshold as acceptance radius, a station one
 * with hold time; the speed to a goal is a DO_CHANGE_SPEED before it, repetitions are DO_JUMP.
 */
public final class GoalItems {
  private static final String HOME = "home";
  private static final double AIRSPEED = 0.0; // through the air or water, as goals have it
  private static final double VEHICLE_CHOOSES = -2.0; // of DO_CHANGE_SPEED
  private static final double FOREVER = -1.0; // of DO_JUMP
  private static final double UNCHANGED = -1.0; // throttle of DO_CHANGE_SPEED
  private static final String SPEED = "speed";
  private static final String THRESHOLD = "horizontalThreshold";
  private static final String DURATION = "duration";
  private static final Set<String> SAID =
      Set.of(
          "systemId",
          "timestamp",
          "uid",
          "next",
          "repeatFrom",
          "repeatTimes",
          "referenceFrame",
          "x",
          "y",
          "z",
          "psi",
          THRESHOLD,
          SPEED,
          DURATION);

  private final List<String> lost;
  private final List<PlanItem> items = new ArrayList<>();
  private final Map<String, Integer> idOfGoal = new HashMap<>(); // of the first item to it
  private double speed = VEHICLE_CHOOSES;

  private GoalItems(List<String> lost) {
    this.lost = lost;
  }

  /**
   * Converts goals in file order.
   *
   * @param lost receives what items cannot say, a line each
   */
  public static List<PlanItem> of(List<GoalInformation> goals, List<String> lost) {
    GoalItems made = new GoalItems(lost);
    made.addAll(goals);
    return made.items;
  }

  private void addAll(List<GoalInformation> goals) {
    Map<String, GoalInformation> byName = new HashMap<>();
    goals.forEach(goal -> byName.put(goal.uid(), goal));
    for (int i = 0; i < goals.size(); i++) {
      if (!goals.get(i).uid().equals(Integer.toString(i + 1))) {
        lose(goals.get(i), "its name");
      }
    }
    List<GoalInformation> way =
        goals.stream().allMatch(goal -> goal.next().isEmpty()) ? goals : way(goals.get(0), byName);
    GoalInformation last = way.get(way.size() - 1);
    String after = last.next().isEmpty() ? "" : last.next().get(0);
    Set<String> targets = new HashSet<>(List.of(after));
    way.forEach(goal -> goal.repeatFrom().ifPresent(targets::add));
    for (GoalInformation goal : way) {
      add(goal, targets.contains(goal.uid()));
      goal.repeatFrom().ifPresent(from -> jump(goal, from, goal.repeatTimes().orElse(1)));
    }
    if (idOfGoal.containsKey(after)) {
      jump(last, after, FOREVER);
    } else if (after.equals(HOME)) {
      items.add(PlanItem.order(nextId(), PlanItem.RETURN));
    }
    goals.stream()
        .filter(goal -> !idOfGoal.containsKey(goal.uid()))
        .forEach(goal -> lose(goal, "is not on the way from goal to goal"));
  }

  /** The goals that follow each other from the first, until one comes again or none follows. */
  private List<GoalInformation> way(GoalInformation first, Map<String, GoalInformation> byName) {
    Set<GoalInformation> way = new LinkedHashSet<>();
    GoalInformation goal = first;
    while (goal != null && way.add(goal)) {
      if (goal.next().size() > 1) {
        lose(goal, "has several next goals");
      }
      goal = goal.next().isEmpty() ? null : byName.get(goal.next().get(0));
    }
    return new ArrayList<>(way);
  }

  private void jump(GoalInformation from, String to, double times) {
    if (idOfGoal.containsKey(to)) {
      items.add(PlanItem.order(nextId(), PlanItem.JUMP, idOfGoal.get(to), times));
    } else {
      lose(from, "repeats from \"" + to + "\", which does not come before it");
    }
  }

  private int nextId() {
    return items.size() + 1;
  }

  private void add(GoalInformation goal, boolean isTarget) {
    int first = nextId();
    idOfGoal.put(goal.uid(), first);
    Map<String, Object> fields = new HashMap<>();
    for (FieldValue field : goal.enumerateFields()) {
      field.value().ifPresent(value -> fields.put(field.name(), value));
    }
    boolean isStation = goal.type() == Station.TYPE;
    if (!isStation && goal.type() != Waypoint.TYPE) {
      lose(goal, "is a " + goal.type().name() + ", which no item is");
      return;
    }
    fields.forEach(
        (name, value) -> {
          boolean isDefault = Boolean.FALSE.equals(value) || List.of().equals(value);
          if (!SAID.contains(name) && !isDefault) {
            lose(goal, "has " + name + " " + value);
          }
        });
    boolean isGlobal = ((Waypoint) goal).referenceFrame().equals(ReferenceFrame.GLOBAL);
    if (!isGlobal || !fields.containsKey("x") || !fields.containsKey("y")) {
      lose(goal, "has no longitude and latitude in the frame Global");
      return;
    }
    speed((double) fields.getOrDefault(SPEED, VEHICLE_CHOOSES), isTarget);
    position(goal, isStation, fields);
  }

  /** A goal to which the mission jumps states its speed again, whatever it was where it jumped. */
  private void speed(double wanted, boolean isTarget) {
    if (wanted != speed || isTarget) {
      items.add(PlanItem.order(nextId(), PlanItem.CHANGE_SPEED, AIRSPEED, wanted, UNCHANGED));
    }
    speed = wanted;
  }

  private void position(GoalInformation goal, boolean isStation, Map<String, Object> fields) {
    double heading =
        fields.containsKey("psi") ? Math.toDegrees((double) fields.get("psi")) : Double.NaN;
    double radius = (double) fields.getOrDefault(THRESHOLD, 0.0);
    List<Double> place =
        List.of(
            (double) fields.get("y"),
            (double) fields.get("x"),
            (double) fields.getOrDefault("z", Double.NaN));
    if (isStation && !fields.containsKey(DURATION)) {
      if (fields.containsKey(THRESHOLD)) {
        lose(goal, "stays with no end within " + THRESHOLD + " " + radius + " m");
      }
      items.add(
          PlanItem.at(
              nextId(), PlanItem.LOITER_UNLIMITED, PlanItem.GLOBAL, place, 0.0, 0.0, 0.0, heading));
      return;
    }
    double stay = (double) fields.getOrDefault(DURATION, 0.0);
    items.add(
        PlanItem.at(
            nextId(), PlanItem.WAYPOINT, PlanItem.GLOBAL, place, stay, radius, 0.0, heading));
  }

  private void lose(GoalInformation goal, String what) {
    lost.add("goal \"" + goal.uid() + "\": " + what);
  }
}
