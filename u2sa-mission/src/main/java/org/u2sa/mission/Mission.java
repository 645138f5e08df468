package org.u2sa.mission;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageTypes;

/**
 * A mission as read from its file (docs/missions.md): the goals in file order, and the home. Its
 * goals have unique names and are frozen, except waypoints without a threshold (see {@link
 * #load(Path)}), which cannot be published.
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
   * Reads a mission with all goal classes on the class path, without defaults: a waypoint whose
   * horizontal threshold is omitted has none, and its getter throws. The default depends on the
   * vehicle (variable DEFAULT THRESHOLD of its Mission Manager).
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
   * @param types registry of goal classes
   * @param defaultThresholdM horizontal threshold of waypoints that give none [m], positive
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static Mission load(Path file, MessageTypes types, double defaultThresholdM) {
    return parse(XmlReader.read(file, "mission"), types, OptionalDouble.of(defaultThresholdM));
  }

  static Mission parse(XmlElement root, MessageTypes types, OptionalDouble defaultThresholdM) {
    return new MissionReader(types, defaultThresholdM).read(root);
  }

  /** The file name as given by the user. */
  public String origin() {
    return origin;
  }

  /** Start position of the vehicle; empty if not given. */
  public Optional<Home> home() {
    return home;
  }

  /** Goals in file order; at least one. */
  public List<GoalInformation> goals() {
    return goals;
  }

  /** Time limit of the mission [s], above 0; empty: unlimited. */
  public OptionalDouble timeLimit() {
    return limit.map(each -> OptionalDouble.of(each.seconds())).orElseGet(OptionalDouble::empty);
  }

  /** Goals to pursue when {@link #timeLimit()} has expired; empty: the mission ends. */
  public List<String> afterTimeLimit() {
    return limit.map(MissionLimit::next).orElse(Collections.emptyList());
  }

  /** {@link #timeLimit()}, and the goals that follow. */
  Optional<MissionLimit> limit() {
    return limit;
  }

  /**
   * Error to report if a vehicle cannot start at this home; names file, line and element.
   *
   * @param child invalid child of {@code <home>}, such as {@code y}
   * @param what value and expected value
   */
  public BadInputException homeError(String child, String what) {
    XmlElement element = root.child("home").orElse(root);
    return element.child(child).orElse(element).error(what);
  }

  /**
   * Error to report if a goal cannot be used; names file, line and element.
   *
   * @param index index of the goal in {@link #goals}
   * @param what problem and expected value
   */
  public BadInputException goalError(int index, String what) {
    return root.children().stream()
        .filter(element -> !element.name().equals(Home.NAME))
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
