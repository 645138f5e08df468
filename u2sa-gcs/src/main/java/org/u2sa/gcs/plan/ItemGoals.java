package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;

/** Items as goals: the inverse of {@link GoalItems}. */
public final class ItemGoals {
  private static final String HOME = "home";
  private static final double LARGEST = 1.0e6; // parameter: times, s, m, m/s

  private final ItemPlaces places;
  private final ItemOrders orders;
  private final List<PlanItem> items;
  private final boolean hasHome;
  private final List<String> lost;
  private final List<String> details;
  private final List<GoalInformation> goals = new ArrayList<>();
  private final Map<Integer, Integer> goalFrom = new HashMap<>(); // index by ID of item before it
  private final List<Integer> pending = new ArrayList<>(); // items whose goal follows
  private final List<List<String>> next = new ArrayList<>();
  private boolean isOver; // set by an item that ends the mission

  private ItemGoals(StationPlan plan, List<String> lost, List<String> details) {
    items = plan.items();
    hasHome = plan.home().isPresent();
    places = new ItemPlaces(plan.home(), lost, details);
    orders = new ItemOrders(places, lost, details);
    this.lost = lost;
    this.details = details;
  }

  /**
   * Converts the items of a plan.
   *
   * @param lost receives the items without a corresponding goal, one line each
   * @param details receives parameters without a corresponding field
   */
  public static ItemGoals of(StationPlan plan, List<String> lost, List<String> details) {
    ItemGoals made = new ItemGoals(plan, lost, details);
    plan.items().forEach(made::add);
    if (made.orders.isIncomplete()) {
      lost.add("the landing starts after the last goal; expected one");
    }
    made.link();
    return made;
  }

  /** The goals, with their numbers from 1 as names. */
  public List<GoalInformation> goals() {
    return goals;
  }

  /** Name of the goal to which each item belongs or leads; "" if none. */
  public List<String> names() {
    List<String> names = new ArrayList<>();
    for (PlanItem item : items) {
      Integer index = goalFrom.get(item.id());
      String end = item.command() == PlanItem.RETURN ? HOME : "";
      names.add(index == null ? end : goals.get(index).uid());
    }
    return names;
  }

  private void lose(PlanItem item, String what) {
    lost.add(item.title() + ": " + what);
  }

  private void detail(PlanItem item, String what) {
    details.add(item.title() + ": " + what);
  }

  private void add(PlanItem item) {
    pending.add(item.id());
    if (isOver) {
      lose(item, "comes after the end of the route");
      return;
    }
    if (item.parameters().stream().anyMatch(each -> Math.abs(each) > LARGEST)) {
      lose(item, "has a parameter beyond " + LARGEST);
      return;
    }
    if (!item.goesOn()) {
      detail(item, "waits for an operator before the next item");
    }
    switch (item.command()) {
      case PlanItem.JUMP -> jump(item);
      case PlanItem.RETURN -> returning(item);
      default -> {
        if (ItemPlaces.COMMANDS.contains(item.command())) {
          places.waypoint(item).ifPresent(this::take);
        } else if (!orders.take(item)) {
          lose(item, "no goal can express that");
        }
      }
    }
  }

  private void take(Waypoint goal) {
    goal.uid(Integer.toString(goals.size() + 1));
    orders.applyTo(goal, goals.size());
    pending.forEach(id -> goalFrom.put(id, goals.size()));
    pending.clear();
    goals.add(goal);
    next.add(List.of());
  }

  /** Jumps back: a counted jump becomes a repetition, an endless jump a loop of the mission. */
  private void jump(PlanItem item) {
    Integer target = goalFrom.get((int) item.parameter(1));
    double times = item.parameter(2);
    if (target == null || goals.isEmpty()) {
      lose(item, "jumps to item " + item.parameter(1) + ", which is not an earlier goal");
      return;
    }
    orders.jump(item, (Waypoint) goals.get(target), target);
    GoalInformation last = goals.get(goals.size() - 1);
    if (times < 0.0) {
      next.set(goals.size() - 1, List.of(Integer.toString(target + 1)));
      isOver = true;
    } else if (times >= 1.0 && last.repeatFrom().isEmpty()) {
      last.repeatFrom(Integer.toString(target + 1)).repeatTimes((long) times);
    } else if (times != 0.0) {
      lose(item, "jumps " + times + " times, or is the second jump at the same point");
    }
  }

  private void returning(PlanItem item) {
    if (goals.isEmpty() || !hasHome) {
      lose(item, goals.isEmpty() ? "nothing comes before it" : "home is unknown");
      return;
    }
    next.set(goals.size() - 1, List.of(HOME));
    isOver = true;
  }

  /** If one goal names its successor, all must. */
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
