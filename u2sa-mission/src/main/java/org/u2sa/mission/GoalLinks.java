package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;

/**
 * Links of a goal's element to following goals, beyond a plain {@code <next>}: {@code <next
 * if="failed">}, {@code <end if="failed"/>} and {@code <repeat from="gate" times="2"/>}.
 */
final class GoalLinks {
  /** Elements that are not fields. */
  static final List<String> ELEMENTS = List.of("repeat", "end");

  private static final String IF = "if";
  private static final Map<String, GoalResult> RESULTS = new LinkedHashMap<>();
  private static final int MAX_TIMES = 1_000_000;

  static {
    RESULTS.put("done", GoalResult.DONE);
    RESULTS.put("failed", GoalResult.FAILED);
    RESULTS.put("timed out", GoalResult.TIMED_OUT);
  }

  private final XmlElement goal;
  private final Map<GoalResult, List<String>> byResult = new EnumMap<>(GoalResult.class);
  private final Map<GoalResult, XmlElement> ends = new EnumMap<>(GoalResult.class);
  private final Map<XmlElement, List<String>> names = new LinkedHashMap<>(); // by element
  private XmlElement repeat; // null if none

  GoalLinks(XmlElement goal) {
    this.goal = goal;
  }

  /** Records the child if it is a link; false if it is a field. */
  boolean takes(XmlElement child) {
    if (child.name().equals("end")) {
      end(child);
    } else if (child.name().equals("repeat")) {
      repeat(child);
    } else if (!child.name().equals("next")) {
      return false;
    } else if (child.optionalAttribute(IF).isPresent()) {
      next(child);
    } else {
      names.put(child, split(child.text()));
      return false; // also a field
    }
    return true;
  }

  private void next(XmlElement child) {
    child.refuseUnknownAttributes(IF);
    child.refuseUnknownChildren();
    List<String> named = split(child.text());
    if (named.isEmpty()) {
      throw child.error("is empty; expected names of goals, or <end if=\"…\"/>");
    }
    GoalResult result = result(child);
    if (ends.containsKey(result)) {
      throw child.error(
          "contradicts <end> in line " + ends.get(result).line() + "; expected one of the two");
    }
    byResult.computeIfAbsent(result, each -> new ArrayList<>()).addAll(named);
    names.put(child, named);
  }

  private void end(XmlElement child) {
    child.refuseUnknownAttributes(IF);
    child.refuseUnknownChildren();
    child.refuseText();
    child.attribute(IF);
    GoalResult result = result(child);
    if (byResult.containsKey(result)) {
      throw child.error(
          "contradicts <next if=\""
              + child.attribute(IF)
              + "\"> of the same goal; expected only "
              + "one");
    }
    ends.put(result, child);
    byResult.put(result, new ArrayList<>());
  }

  private void repeat(XmlElement child) {
    child.refuseUnknownAttributes("from", "times");
    child.refuseUnknownChildren();
    child.refuseText();
    if (repeat != null) {
      throw child.error("appears twice; repeat is already in line " + repeat.line());
    }
    repeat = child;
    names.put(child, List.of(child.attribute("from")));
    times();
  }

  private long times() {
    String text = repeat.attribute("times");
    if (!text.matches("[0-9]{1,7}")
        || Long.parseLong(text) < 1
        || Long.parseLong(text) > MAX_TIMES) {
      throw repeat.error("times: \"" + text + "\"; expected 1…" + MAX_TIMES);
    }
    return Long.parseLong(text);
  }

  private static GoalResult result(XmlElement child) {
    String text = child.attribute(IF);
    String plain = text.toLowerCase(Locale.ROOT).replaceAll("[ _-]+", " ").trim();
    GoalResult result = RESULTS.get(plain);
    if (result == null) {
      throw child.error(
          String.format(
              "if: \"%s\" is not a result of a goal; expected one of %s%s",
              text,
              String.join(", ", RESULTS.keySet()),
              NearestNames.didYouMean(plain, RESULTS.keySet())));
    }
    return result;
  }

  static List<String> split(String text) {
    return Stream.of(text.split(","))
        .map(String::trim)
        .filter(part -> !part.isEmpty())
        .collect(Collectors.toList());
  }

  /** Sets the links in the goal, and rejects impossible ones. */
  void readInto(GoalInformation message) {
    byResult.forEach(message::nextIf);
    if (repeat != null) {
      message.repeatFrom(repeat.attribute("from")).repeatTimes(times());
    }
    if (message.timeLimit().orElse(1.0) == 0.0) {
      throw goal.child("timeLimit")
          .orElse(goal)
          .error("0.0 s expires immediately; expected more than 0 s");
    }
    if (message.choose().orElse(1) < 1) {
      throw goal.child("choose")
          .orElse(goal)
          .error(message.choose().getAsLong() + " goals; expected at least 1");
    }
    Optional<XmlElement> late =
        names.keySet().stream().filter(each -> result(each, "timed out")).findFirst();
    if (late.isPresent() && message.timeLimit().isEmpty()) {
      throw late.get()
          .error(
              "if: the goal never times out because it has no <timeLimit>; expected one in "
                  + "the same goal");
    }
  }

  private static boolean result(XmlElement element, String text) {
    return element.name().equals("next")
        && element.optionalAttribute(IF).isPresent()
        && result(element) == RESULTS.get(text);
  }

  /** Rejects names that are not among these, at the element that names them. */
  void refuseOthers(Collection<String> known) {
    names.forEach((element, named) -> named.forEach(name -> refuseUnless(known, element, name)));
  }

  static void refuseUnless(Collection<String> known, XmlElement element, String name) {
    if (!known.contains(name)) {
      throw element.error(
          String.format(
              "\"%s\" names no goal; the goals are %s%s",
              name, String.join(", ", known), NearestNames.didYouMean(name, known)));
    }
  }
}
