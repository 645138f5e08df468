package org.u2sa.gcs.mavlink.plan;

import java.util.List;

/**
 * A mission as a list of items.
 *
 * @param origin name under which the Mission Manager knows it
 * @param items in order
 * @param goals name of the goal that each item represents; an action has the name of the next
 *     place, "" after the last
 */
record MissionPlan(String origin, List<MissionItem> items, List<String> goals) {
  MissionPlan {
    items = List.copyOf(items);
    goals = List.copyOf(goals);
  }

  /** Index of the item that represents a goal; −1 if none does. */
  int indexOf(String goal) {
    return goals.lastIndexOf(goal); // actions before the place also have its name
  }
}
