package org.u2sa.trials.run;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;

/** Names of the goals of missions that replace the run's own, once the order is accepted. */
final class ReplacedGoals {
  private static final int MAX_PENDING = 100;

  private final Map<String, Set<String>> pending = new HashMap<>(); // by request

  void see(MissionOrder order) {
    if (order.action() == MissionAction.REPLACE && pending.size() < MAX_PENDING) {
      pending.put(order.requestId(), names(order.goals().orElse("")));
    }
  }

  /** Names of the new mission's goals; empty if this result accepts no replacement. */
  Optional<Set<String>> accepted(MissionOrderResult result) {
    return Optional.ofNullable(pending.remove(result.requestId()))
        .filter(names -> result.accepted());
  }

  private static Set<String> names(String mission) {
    Set<String> names = new LinkedHashSet<>();
    try {
      byte[] bytes = mission.getBytes(StandardCharsets.UTF_8);
      XmlElement root = XmlReader.read(new ByteArrayInputStream(bytes), "order", "mission");
      for (XmlElement goal : root.children()) {
        goal.child("name").map(XmlElement::text).ifPresent(names::add);
      }
    } catch (BadInputException e) {
      // the Mission Manager refuses it
    }
    return names;
  }
}
