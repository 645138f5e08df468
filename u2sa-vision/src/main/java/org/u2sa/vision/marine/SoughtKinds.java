package org.u2sa.vision.marine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SoughtObjects;

/**
 * Kinds of objects needed by the current goals (thesis 4.2.1.2, 4.3.2): by the variable KINDS BY
 * GOAL, or else by the types of objects that a goal names ({@link SoughtObjects}); other goals need
 * all configured kinds.
 */
final class SoughtKinds {
  private final Set<MarineKind> configured;
  private final Set<MarineKind> always;
  private final Map<String, Set<MarineKind>> byGoal = new HashMap<>();
  private Set<MarineKind> sought;
  private long pictures;
  private long idlePictures;
  private long searches;
  private long savedSearches;

  /**
   * @param kinds comma-separated class names that the service can look for
   * @param always the kinds looked for regardless of the goal
   * @param byGoal "SpeedGate: Buoy, Pole; Return:", per goal class
   * @throws BadInputException if a name is not that of a kind
   */
  SoughtKinds(String kinds, String always, String byGoal) {
    configured = read("KINDS", kinds);
    this.always = read("ALWAYS", always);
    for (String entry : byGoal.split(";")) {
      if (!entry.trim().isEmpty()) {
        int colon = entry.indexOf(':');
        if (colon < 1) {
          throw new BadInputException(
              "KINDS BY GOAL \"" + entry.trim() + "\": expected GOAL CLASS: KIND, KIND");
        }
        this.byGoal.put(
            entry.substring(0, colon).trim(), read("KINDS BY GOAL", entry.substring(colon + 1)));
      }
    }
    sought = configured;
  }

  private static Set<MarineKind> read(String variable, String names) {
    Set<MarineKind> kinds = EnumSet.noneOf(MarineKind.class);
    for (String name : names.split(",")) {
      if (!name.trim().isEmpty()) {
        kinds.add(
            MarineKind.of(name)
                .orElseThrow(
                    () ->
                        new BadInputException(
                            variable
                                + " \""
                                + name.trim()
                                + "\": expected kinds among "
                                + Arrays.toString(MarineKind.values()))));
      }
    }
    return kinds;
  }

  void goals(GoalList list) {
    Set<MarineKind> kinds = EnumSet.noneOf(MarineKind.class);
    for (GoalInformation goal : list.goals()) {
      kinds.addAll(needed(goal));
    }
    kinds.addAll(always);
    kinds.retainAll(configured);
    sought = kinds;
  }

  private Collection<MarineKind> needed(GoalInformation goal) {
    List<String> chain = goal.typeChain();
    for (int i = chain.size() - 1; i >= 0; i--) {
      Set<MarineKind> named = byGoal.get(chain.get(i));
      if (named != null) {
        return named;
      }
    }
    Set<String> types = SoughtObjects.of(goal);
    if (types.isEmpty()) {
      return configured;
    }
    List<MarineKind> kinds = new ArrayList<>();
    types.forEach(name -> MarineKind.of(name).ifPresent(kinds::add));
    return kinds;
  }

  /** Kinds to look for in a picture; counts the picture. */
  Set<MarineKind> next() {
    pictures++;
    searches += sought.size();
    savedSearches += configured.size() - sought.size();
    if (sought.isEmpty()) {
      idlePictures++;
    }
    return sought;
  }

  /** Savings so far, for the health report. */
  String remark() {
    return String.format(
        "looking for %s; %d of %d pictures not processed, %d of %d searches saved",
        sought, idlePictures, pictures, savedSearches, searches + savedSearches);
  }
}
