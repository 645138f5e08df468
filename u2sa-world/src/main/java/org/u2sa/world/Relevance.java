package org.u2sa.world;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SoughtObjects;

/**
 * Selects the objects relevant to the current task (thesis 3.2.3.3, 4.3.2). A goal of any class can
 * name the objects it looks for in a field objectType or objectTypes. While every current goal does
 * so, passable objects of other types are omitted. Everything else is always published: a vehicle
 * on its way to a buoy must not run into the gate.
 */
final class Relevance {
  private Set<String> wanted = Set.of(); // empty: all

  void of(GoalList goals) {
    wanted = SoughtObjects.of(goals);
  }

  /** Restores the relevant types of a predecessor. */
  void want(Collection<String> types) {
    wanted = new TreeSet<>(types);
  }

  /** Types named by the goals; empty means all. */
  Set<String> types() {
    return wanted;
  }

  List<ObjectDescription> of(List<ObjectDescription> objects) {
    if (wanted.isEmpty()) {
      return objects;
    }
    List<ObjectDescription> relevant = new ArrayList<>();
    for (ObjectDescription object : objects) {
      boolean isPassable = object.level().filter(ObjectLevel.HINDRANCE::equals).isPresent();
      if (!isPassable || wanted.contains(object.objectType())) {
        relevant.add(object);
      }
    }
    return relevant;
  }
}
