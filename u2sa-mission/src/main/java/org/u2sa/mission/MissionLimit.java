package org.u2sa.mission;

import java.util.Collection;
import java.util.List;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * Time limit of a mission: {@code <timeLimit unit="min" next="home">20</timeLimit>}.
 *
 * @param seconds time limit, above 0
 * @param next goals to pursue when it has expired; empty: the mission ends
 */
record MissionLimit(double seconds, List<String> next) {
  static final String ELEMENT = "timeLimit";

  MissionLimit {
    next = List.copyOf(next);
  }

  static MissionLimit read(XmlElement element, Collection<String> known) {
    element.refuseUnknownAttributes("unit", "next");
    element.refuseUnknownChildren();
    double seconds = XmlNumbers.converted(element, "s", "s");
    if (!(seconds > 0.0)) {
      throw element.error(seconds + " s; expected more than 0 s");
    }
    List<String> next = GoalLinks.split(element.optionalAttribute("next").orElse(""));
    next.forEach(name -> GoalLinks.refuseUnless(known, element, name));
    return new MissionLimit(seconds, next);
  }
}
