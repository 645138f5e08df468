package org.u2sa.messages.goal;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.messages.schema.FieldValue;

/**
 * Types of objects that goals look for (thesis 4.2.1.2, 4.3.2). A goal of any class names them in a
 * field objectType or objectTypes.
 */
public final class SoughtObjects {
  private static final String ONE = "objectType";
  private static final String SEVERAL = "objectTypes";

  private SoughtObjects() {}

  /** Types named by the current goals; empty without goals, or if any goal names none. */
  public static Set<String> of(GoalList goals) {
    Set<String> types = new TreeSet<>();
    for (GoalInformation goal : goals.goals()) {
      Set<String> its = of(goal);
      if (its.isEmpty()) {
        return new TreeSet<>(); // a goal without types may need anything
      }
      types.addAll(its);
    }
    return types;
  }

  /** Types that a goal names; empty if it names none. */
  public static Set<String> of(GoalInformation goal) {
    Set<String> types = new TreeSet<>();
    for (FieldValue field : goal.enumerateFields()) {
      boolean names = field.name().equals(ONE) || field.name().equals(SEVERAL);
      Optional<Object> value = names ? field.value() : Optional.empty();
      if (value.isPresent()) {
        Object given = value.get();
        Collection<?> all = given instanceof Collection<?> list ? list : List.of(given);
        all.forEach(type -> types.add(type.toString().trim()));
      }
    }
    types.remove("");
    return types;
  }
}
