package org.u2sa.trials.run;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;

/**
 * The mission's goals as operators change them: those they insert, and missions that replace it.
 */
final class OrderedGoals {
  private static final int MAX_PENDING = 100;
  private static final Set<MissionAction> ADDING =
      EnumSet.of(MissionAction.INSERT, MissionAction.REPLACE);
  private static final Set<String> NO_GOALS = Set.of("home", "timeLimit"); // in mission files

  /**
   * An accepted order.
   *
   * @param names of its goals; empty for one without a name
   * @param done goals completed before
   */
  private record Change(MissionAction action, List<Optional<String>> names, Set<String> done) {
    /** Goals in force after the change. */
    Set<String> goals(Set<String> before) {
      boolean adds = action == MissionAction.INSERT;
      Set<String> given = new HashSet<>(adds ? before : Set.of());
      names.forEach(name -> name.ifPresent(given::add));
      Set<String> goals = new LinkedHashSet<>(before);
      goals.removeIf(goal -> !adds && !done.contains(goal));
      int number = 0;
      for (Optional<String> name : names) { // unnamed ones are numbered: see docs/missions.md
        number += adds && name.isPresent() ? 0 : 1;
        while (adds && name.isEmpty() && given.contains(String.valueOf(number))) {
          number++;
        }
        goals.add(name.orElse(String.valueOf(number)));
      }
      return goals;
    }
  }

  private final Map<String, MissionOrder> pending = new HashMap<>(); // by request
  private final Set<String> executed = new HashSet<>(); // requests
  private final List<Change> changes = new ArrayList<>();

  void see(MissionOrder order) {
    if (ADDING.contains(order.action())
        && pending.size() < MAX_PENDING
        && !executed.contains(order.requestId())) {
      pending.put(order.requestId(), order);
    }
  }

  /**
   * Processes an answer to an order.
   *
   * @param done goals completed so far
   * @return the goals of a mission that now replaces the former one; empty for other answers
   */
  Optional<Set<String>> answered(MissionOrderResult result, Set<String> done) {
    MissionOrder order = pending.remove(result.requestId());
    if (order == null || !result.accepted()) {
      return Optional.empty();
    }
    executed.add(result.requestId());
    Change change = new Change(order.action(), names(order.goals().orElse("")), Set.copyOf(done));
    changes.add(change);
    return order.action() == MissionAction.REPLACE
        ? Optional.of(new Change(order.action(), change.names(), Set.of()).goals(Set.of()))
        : Optional.empty();
  }

  /**
   * The goals now in force, and those completed before a replacement.
   *
   * @param planned goals of the mission at the start
   */
  Set<String> goals(Set<String> planned) {
    Set<String> goals = planned;
    for (Change change : changes) {
      goals = change.goals(goals);
    }
    return goals;
  }

  private static List<Optional<String>> names(String mission) {
    List<Optional<String>> names = new ArrayList<>();
    try {
      byte[] bytes = mission.getBytes(StandardCharsets.UTF_8);
      XmlElement root = XmlReader.read(new ByteArrayInputStream(bytes), "order", "mission");
      root.children().stream()
          .filter(goal -> !NO_GOALS.contains(goal.name()))
          .forEach(goal -> names.add(goal.child("name").map(XmlElement::text)));
    } catch (BadInputException e) {
      // the Mission Manager refuses it
    }
    return names;
  }
}
