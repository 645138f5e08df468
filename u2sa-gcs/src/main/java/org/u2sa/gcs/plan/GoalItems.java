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
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.MessageType;

/**
 * Goals as items: a waypoint is NAV_WAYPOINT with its threshold as acceptance radius, a take-off
 * NAV_TAKEOFF, a landing NAV_LAND, a station as in {@link StationItems}; {@link WayOrders} come
 * before them, repetitions are DO_JUMP.
 */
public final class GoalItems {
  private static final String HOME = "home";
  private static final double FOREVER = -1.0; // of DO_JUMP
  private static final String THRESHOLD = "horizontalThreshold";
  private static final String NEXT_IF_DONE = "nextIfDone";
  private static final Set<MessageType<?>> ITEMS = Set.of(Waypoint.TYPE, Landing.TYPE);
  private static final Set<String> LINKS = Set.of("nextIfFailed", "nextIfTimedOut", "choose");
  private static final Set<String> SAID =
      Set.of(
          NEXT_IF_DONE,
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
          "speed",
          "duration",
          "radius",
          "turns",
          "towardsNext",
          "photoDistance",
          "lookAt",
          "landingStart");

  private final List<String> lost;
  private final List<String> details;
  private final List<PlanItem> items = new ArrayList<>();
  private final List<String> names = new ArrayList<>();
  private final Map<String, Integer> idOfGoal = new HashMap<>(); // ID of the first item of a goal
  private final WayOrders orders;

  private GoalItems(List<GoalInformation> goals, List<String> lost, List<String> details) {
    orders = new WayOrders(goals);
    this.lost = lost;
    this.details = details;
  }

  /**
   * Converts goals in file order.
   *
   * @param goals at least one
   * @param lost receives what items cannot express of the route, one line each
   * @param details receives everything else they cannot express
   */
  public static GoalItems of(List<GoalInformation> goals, List<String> lost, List<String> details) {
    GoalItems made = new GoalItems(goals, lost, details);
    made.addAll(goals);
    return made;
  }

  /** The items, numbered from 1. */
  public List<PlanItem> items() {
    return items;
  }

  /** Name of the goal to which each item belongs or leads; "" if none. */
  public List<String> names() {
    return names;
  }

  private void addAll(List<GoalInformation> goals) {
    Map<String, GoalInformation> byName = new HashMap<>();
    goals.forEach(goal -> byName.put(goal.uid(), goal));
    for (int i = 0; i < goals.size(); i++) {
      if (!goals.get(i).uid().equals(Integer.toString(i + 1))) {
        detail(goals.get(i), "its name");
      }
    }
    List<GoalInformation> way =
        goals.stream().anyMatch(GoalItems::isLinked) ? way(goals.get(0), byName) : goals;
    GoalInformation last = way.get(way.size() - 1);
    String after = next(last).isEmpty() ? "" : next(last).get(0);
    Set<String> targets = new HashSet<>(List.of(after));
    way.forEach(goal -> goal.repeatFrom().ifPresent(targets::add));
    for (int i = 0; i < way.size(); i++) {
      GoalInformation goal = way.get(i);
      String following = i + 1 < way.size() ? way.get(i + 1).uid() : "";
      add(goal, targets.contains(goal.uid()));
      goal.repeatFrom()
          .ifPresent(from -> jump(goal, from, goal.repeatTimes().orElse(1), following));
    }
    if (idOfGoal.containsKey(after)) {
      jump(last, after, FOREVER, "");
    } else if (after.equals(HOME)) {
      add(PlanItem.order(nextId(), PlanItem.RETURN), HOME);
    }
    goals.stream()
        .filter(goal -> !idOfGoal.containsKey(goal.uid()))
        .forEach(goal -> lose(goal, "cannot be reached from the first goal"));
  }

  /** The chain of goals from the first, until one recurs or has no successor. */
  private List<GoalInformation> way(GoalInformation first, Map<String, GoalInformation> byName) {
    Set<GoalInformation> way = new LinkedHashSet<>();
    GoalInformation goal = first;
    while (goal != null && way.add(goal)) {
      List<String> next = next(goal);
      if (next.size() > 1) {
        lose(goal, "has several next goals");
      }
      goal = next.isEmpty() ? null : byName.get(next.get(0));
    }
    return new ArrayList<>(way);
  }

  private static boolean isLinked(GoalInformation goal) {
    return !goal.next().isEmpty() || goal.nextIf(GoalResult.DONE).isPresent();
  }

  private static List<String> next(GoalInformation goal) {
    return goal.nextIf(GoalResult.DONE).orElse(goal.next());
  }

  private void jump(GoalInformation from, String to, double times, String following) {
    if (idOfGoal.containsKey(to)) {
      add(PlanItem.order(nextId(), PlanItem.JUMP, idOfGoal.get(to), times), following);
    } else {
      lose(from, "repeats from \"" + to + "\", which does not come before it");
    }
  }

  private int nextId() {
    return items.size() + 1;
  }

  private void add(PlanItem item, String name) {
    items.add(item);
    names.add(name);
  }

  private void add(GoalInformation goal, boolean isTarget) {
    int first = nextId();
    idOfGoal.put(goal.uid(), first);
    Map<String, Object> fields = new HashMap<>();
    for (FieldValue field : goal.enumerateFields()) {
      field.value().ifPresent(value -> fields.put(field.name(), value));
    }
    boolean isStation = goal.type() == Station.TYPE;
    boolean isTakeOff = goal.type() == TakeOff.TYPE;
    if (!isStation && !isTakeOff && !ITEMS.contains(goal.type())) {
      lose(goal, "is of type " + goal.type().name() + ", which no item can express");
      return;
    }
    loseOthers(goal, fields);
    boolean isHere = isTakeOff || isStation && !fields.containsKey("x") && !fields.containsKey("y");
    boolean isGlobal = ((Waypoint) goal).referenceFrame().equals(ReferenceFrame.GLOBAL);
    boolean isPlace = isGlobal && fields.containsKey("x") && fields.containsKey("y");
    boolean isZero = isPlace && (double) fields.get("x") == 0.0 && (double) fields.get("y") == 0.0;
    if (isZero && !isTakeOff) {
      lose(goal, "is at 0, 0, which in items means the present position");
      return;
    }
    if (isHere ? fields.containsKey("z") && !isGlobal : !isPlace) {
      lose(goal, "has no longitude and latitude in the frame Global");
      return;
    }
    Waypoint at = (Waypoint) goal;
    orders.before(at, isTarget, nextId()).forEach(order -> add(order, goal.uid()));
    add(position(at, fields), goal.uid());
  }

  private void loseOthers(GoalInformation goal, Map<String, Object> fields) {
    boolean isPlain = goal.next().isEmpty() && goal.repeatFrom().isEmpty();
    fields.forEach(
        (name, value) -> {
          String what = "has " + name + " " + value;
          if (LINKS.contains(name)) {
            lose(goal, what);
          } else if (name.equals(NEXT_IF_DONE) && !isPlain) {
            lose(goal, what + " in addition");
          } else if (!SAID.contains(name) && !Boolean.FALSE.equals(value)) {
            detail(goal, what);
          }
        });
  }

  private PlanItem position(Waypoint goal, Map<String, Object> fields) {
    double heading =
        fields.containsKey("psi") ? Math.toDegrees((double) fields.get("psi")) : Double.NaN;
    double radius = (double) fields.getOrDefault(THRESHOLD, 0.0);
    List<Double> place =
        List.of(
            (double) fields.getOrDefault("y", 0.0),
            (double) fields.getOrDefault("x", 0.0),
            (double) fields.getOrDefault("z", Double.NaN));
    if (goal instanceof Station station) {
      return StationItems.of(nextId(), station, place, radius, heading, what -> detail(goal, what));
    }
    boolean isTakeOff = goal instanceof TakeOff;
    if (isTakeOff || goal instanceof Landing) {
      if (radius > 0.0) {
        detail(goal, "has " + THRESHOLD + " " + radius);
      }
      if (isTakeOff && goal.x().isPresent()) {
        detail(goal, "has a place");
      }
      return PlanItem.at(
          nextId(),
          isTakeOff ? PlanItem.TAKE_OFF : PlanItem.LAND,
          PlanItem.GLOBAL,
          isTakeOff ? List.of(0.0, 0.0, place.get(2)) : place,
          0.0,
          0.0,
          0.0,
          heading);
    }
    return PlanItem.at(
        nextId(), PlanItem.WAYPOINT, PlanItem.GLOBAL, place, 0.0, radius, 0.0, heading);
  }

  private void lose(GoalInformation goal, String what) {
    lost.add("goal \"" + goal.uid() + "\": " + what);
  }

  private void detail(GoalInformation goal, String what) {
    details.add("goal \"" + goal.uid() + "\": " + what);
  }
}
