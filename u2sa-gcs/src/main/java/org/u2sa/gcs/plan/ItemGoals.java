package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;

/** Items as goals: the inverse of {@link GoalItems}. */
public final class ItemGoals {
  private static final double VEHICLE_CHOOSES = -2.0; // of DO_CHANGE_SPEED
  private static final double UNCHANGED = -1.0; // likewise
  private static final double FULL_TURN_DEG = 360.0;
  private static final int MAX_JUMPS = 1_000_000;

  private final OptionalDouble homeAltitudeM;
  private final List<String> lost;
  private final List<GoalInformation> goals = new ArrayList<>();
  private final Map<Integer, Integer> goalFrom = new HashMap<>(); // index by ID of item before it
  private final List<Integer> pending = new ArrayList<>(); // items whose goal follows
  private final Map<Integer, Double> statedSpeeds = new HashMap<>(); // by index of goal
  private final List<List<String>> next = new ArrayList<>();
  private double speed = VEHICLE_CHOOSES;
  private boolean isStated; // the speed, since the last goal
  private boolean isOver; // an item that ends the way came

  private ItemGoals(StationPlan plan, List<String> lost) {
    homeAltitudeM = plan.home().map(StationPlan.Place::altitudeM).orElse(OptionalDouble.empty());
    this.lost = lost;
  }

  /**
   * Converts the items of a plan.
   *
   * @param lost receives what goals cannot say, a line each
   * @return goals with their numbers as names
   */
  public static List<GoalInformation> of(StationPlan plan, List<String> lost) {
    ItemGoals made = new ItemGoals(plan, lost);
    plan.items().forEach(made::add);
    made.link();
    return made.goals;
  }

  private void lose(PlanItem item, String what) {
    lost.add(item.title() + ": " + what);
  }

  private void add(PlanItem item) {
    pending.add(item.id());
    if (isOver) {
      lose(item, "comes after the end of the way");
      return;
    }
    if (!item.goesOn()) {
      lose(item, "waits for an operator before the next item");
    }
    switch (item.command()) {
      case PlanItem.WAYPOINT -> position(item, item.parameter(1), item.parameter(2), 3);
      case PlanItem.LOITER_UNLIMITED -> position(item, Double.NaN, 0.0, 3);
      case PlanItem.LOITER_TIME -> position(item, item.parameter(1), 0.0, 3);
      case PlanItem.TAKE_OFF -> takeOff(item);
      case PlanItem.CHANGE_SPEED -> speed(item);
      case PlanItem.JUMP -> jump(item);
      case PlanItem.RETURN -> returning(item);
      default -> lose(item, "no goal says that");
    }
  }

  /** Vehicles take off by themselves; what is left is the place behind. */
  private void takeOff(PlanItem item) {
    if (item.parameter(1) > 0.0) {
      lose(item, "a pitch of " + item.parameter(1) + " deg");
    }
    position(item, 0.0, 0.0, 3);
  }

  /**
   * @param stayS time to stay [s]; 0: none, NaN: with no end
   * @param unused number of a parameter, a radius, that must be 0
   */
  private void position(PlanItem item, double stayS, double radiusM, int unused) {
    double latitude = item.parameter(5);
    double longitude = item.parameter(6);
    boolean isPlace =
        Math.abs(latitude) <= FULL_TURN_DEG / 4
            && Math.abs(longitude) <= FULL_TURN_DEG / 2
            && !(latitude == 0.0 && longitude == 0.0);
    if (!isPlace) { // 0, 0 means the present position
      lose(item, "latitude " + latitude + ", longitude " + longitude + " is no place");
      return;
    }
    if (item.parameter(unused) != 0.0 && !Double.isNaN(item.parameter(unused))) {
      lose(item, "a radius of " + item.parameter(unused) + " m to pass or to circle");
    }
    Waypoint goal = stayS == 0.0 ? new Waypoint() : new Station();
    if (goal instanceof Station station && stayS > 0.0) {
      station.duration(stayS);
    }
    goal.x(longitude).y(latitude);
    altitude(item).ifPresent(goal::z);
    if (radiusM > 0.0) {
      goal.horizontalThreshold(radiusM);
    }
    double heading = item.parameter(4);
    if (Double.isFinite(heading)) {
      goal.psi(Math.toRadians((heading % FULL_TURN_DEG + FULL_TURN_DEG) % FULL_TURN_DEG));
    }
    if (speed != VEHICLE_CHOOSES) {
      goal.speed(speed);
    }
    take(goal.uid(Integer.toString(goals.size() + 1)));
  }

  private void take(GoalInformation goal) {
    pending.forEach(id -> goalFrom.put(id, goals.size()));
    pending.clear();
    if (isStated) {
      statedSpeeds.put(goals.size(), speed);
    }
    isStated = false;
    goals.add(goal);
    next.add(List.of());
  }

  private OptionalDouble altitude(PlanItem item) {
    double z = item.parameter(7);
    if (Double.isNaN(z)) {
      return OptionalDouble.empty();
    }
    switch (item.frame()) {
      case PlanItem.GLOBAL, PlanItem.GLOBAL_INT:
        return OptionalDouble.of(z);
      case PlanItem.RELATIVE, PlanItem.RELATIVE_INT:
        if (homeAltitudeM.isPresent()) {
          return OptionalDouble.of(homeAltitudeM.getAsDouble() + z);
        }
        lose(item, "its altitude is relative to a home without altitude");
        return OptionalDouble.empty();
      default:
        lose(
            item,
            "an altitude in frame "
                + item.frame()
                + "; expected MAV_FRAME_GLOBAL or …_RELATIVE_ALT");
        return OptionalDouble.empty();
    }
  }

  private void speed(PlanItem item) {
    double wanted = item.parameter(2);
    if (item.parameter(1) != 0.0) {
      lose(item, "a speed over ground, climb or descent; goals have that through air or water");
    }
    if (wanted == VEHICLE_CHOOSES || wanted >= 0.0) {
      speed = wanted;
      isStated = true;
    } else if (wanted != UNCHANGED) {
      lose(item, "speed " + wanted + " m/s");
    }
    if (item.parameter(3) > 0.0) {
      lose(item, "a throttle of " + item.parameter(3) + " %");
    }
  }

  /** Jumps back: a number of times is a repetition, endless ones are the way itself. */
  private void jump(PlanItem item) {
    Integer target = goalFrom.get((int) item.parameter(1));
    double times = item.parameter(2);
    if (target == null || goals.isEmpty()) {
      lose(item, "jumps to item " + item.parameter(1) + ", which no goal before it is");
      return;
    }
    if (speed != speedTo(target) && !statedSpeeds.containsKey(target)) {
      lose(item, "jumps to an item at another speed, which a speed item before that must set");
    }
    GoalInformation last = goals.get(goals.size() - 1);
    if (times < 0.0) {
      next.set(goals.size() - 1, List.of(Integer.toString(target + 1)));
      isOver = true;
    } else if (times >= 1.0 && times <= MAX_JUMPS && last.repeatFrom().isEmpty()) {
      last.repeatFrom(Integer.toString(target + 1)).repeatTimes((long) times);
    } else if (times != 0.0) {
      lose(item, "jumps " + times + " times, or is the second jump at its place");
    }
  }

  private double speedTo(int index) {
    return ((Waypoint) goals.get(index)).speed().orElse(VEHICLE_CHOOSES);
  }

  private void returning(PlanItem item) {
    if (goals.isEmpty()) {
      lose(item, "nothing comes before it");
      return;
    }
    next.set(goals.size() - 1, List.of("home"));
    isOver = true;
  }

  /** One goal that names its next makes all name theirs. */
  private void link() {
    if (next.stream().allMatch(List::isEmpty)) {
      return;
    }
    for (int i = 0; i < goals.size(); i++) {
      if (!next.get(i).isEmpty()) {
        goals.get(i).next(next.get(i));
      } else if (i + 1 < goals.size()) {
        goals.get(i).next(List.of(Integer.toString(i + 2)));
      }
    }
  }
}
