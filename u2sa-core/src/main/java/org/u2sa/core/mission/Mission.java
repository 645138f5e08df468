package org.u2sa.core.mission;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.schema.MessageTypes;

/**
 * A mission as read from its file (docs/missions.md): the goals in file order, and where the
 * vehicle starts. Its goals have unique names and are frozen, but for waypoints that lack a
 * threshold (see {@link #load(Path)}): nobody can publish those.
 */
public final class Mission {
  private final String origin;
  private final Optional<Home> home;
  private final List<GoalInformation> goals;
  private final Optional<MissionLimit> limit;
  private final List<String> warnings;
  private final XmlElement root;

  Mission(
      XmlElement root,
      Optional<Home> home,
      List<GoalInformation> goals,
      Optional<MissionLimit> limit,
      List<String> warnings) {
    this.root = root;
    this.origin = root.origin();
    this.home = home;
    this.limit = limit;
    this.goals = Collections.unmodifiableList(new ArrayList<>(goals));
    this.warnings = Collections.unmodifiableList(new ArrayList<>(warnings));
  }

  /**
   * Reads a mission with all goal classes on the class path, as its file has it: a waypoint for
   * which the file gives no horizontal threshold has none, and asking for it throws. What it is
   * then depends on the vehicle (variable DEFAULT THRESHOLD of its Mission Manager).
   *
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static Mission load(Path file) {
    return parse(
        XmlReader.read(file, "mission"), MessageTypes.discovered(), OptionalDouble.empty());
  }

  /**
   * Reads a mission.
   *
   * @param types among which goal classes are looked up
   * @param defaultThresholdM horizontal threshold of waypoints that give none [m], positive
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static Mission load(Path file, MessageTypes types, double defaultThresholdM) {
    return parse(XmlReader.read(file, "mission"), types, OptionalDouble.of(defaultThresholdM));
  }

  static Mission parse(XmlElement root, MessageTypes types, OptionalDouble defaultThresholdM) {
    return new MissionReader(types, defaultThresholdM).read(root);
  }

  /** The file, as the user named it. */
  public String origin() {
    return origin;
  }

  /** Where the vehicle starts; empty if the mission does not say. */
  public Optional<Home> home() {
    return home;
  }

  /** The goals in the order of the file; at least one. */
  public List<GoalInformation> goals() {
    return goals;
  }

  /** How long the mission may take [s], above 0; empty: as long as it takes. */
  public OptionalDouble timeLimit() {
    return limit.isPresent() ? OptionalDouble.of(limit.get().seconds()) : OptionalDouble.empty();
  }

  /** The goals that are pursued when {@link #timeLimit()} has passed; none: the mission ends. */
  public List<String> afterTimeLimit() {
    return limit.map(MissionLimit::next).orElse(Collections.emptyList());
  }

  /** {@link #timeLimit()}, and what comes when it has passed. */
  Optional<MissionLimit> limit() {
    return limit;
  }

  /**
   * What is wrong with the home for somebody who cannot start there: names file, line and element.
   *
   * @param child of {@code <home>} that is wrong, such as {@code y}
   * @param what value and what was expected
   */
  public BadInputException homeError(String child, String what) {
    XmlElement element = root.child("home").orElse(root);
    return element.child(child).orElse(element).error(what);
  }

  /**
   * What is wrong with a goal for somebody who cannot use it: names file, line and element.
   *
   * @param index of the goal in {@link #goals}
   * @param what is wrong, and what was expected
   */
  public BadInputException goalError(int index, String what) {
    return root.children().stream()
        .filter(element -> !element.name().equals(MissionManager.HOME))
        .filter(element -> !element.name().equals(MissionLimit.ELEMENT))
        .skip(index)
        .findFirst()
        .orElseThrow()
        .error(what);
  }

  /** Warnings, such as unreachable goals: file, line and finding. */
  public List<String> warnings() {
    return warnings;
  }
}
