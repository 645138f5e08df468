package org.u2sa.core.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * Autonomy of a vehicle in the three dimensions of thesis 2.3, with six levels each.
 *
 * @param perception perception of its surroundings (2.3.1)
 * @param decision decision-making (2.3.2, there called intelligence)
 * @param independence independence from people (2.3.3)
 */
public record AutonomyLevels(Perception perception, Decision decision, Independence independence) {
  /** An autonomy level. */
  public interface Level {
    /** Name in code. */
    String name();

    /** Ordinal, from 0. */
    int ordinal();

    /** Level, 1 (lowest) to 6. */
    default int number() {
      return ordinal() + 1;
    }

    /** Name in the thesis's words. */
    default String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /** Level of perception (thesis 2.3.1). */
  public enum Perception implements Level {
    /** No sensors. */
    NO_SENSING,
    /** Single data points, neither grouped nor classified. */
    DISCRETE,
    /** Nearby data points are grouped into objects of one kind. */
    GROUPED,
    /** Objects are classified by programmed characteristics. */
    CLASSIFICATION,
    /** New objects are learnt in a training mode. */
    STATIC_LEARNING,
    /** New objects are learnt in operation. */
    DYNAMIC_LEARNING
  }

  /** Autonomy levels of a system (thesis 2.3.2). */
  public enum Decision implements Level {
    /** Time-triggered manoeuvres. */
    NO_DECISIONS,
    /** Programmed manoeuvres in a known, static environment. */
    STATIC_RESPONSE,
    /** Remembers objects out of sensor range. */
    MEMORY,
    /** Predicts the motion of objects. */
    PROJECTION,
    /** Learns tasks in a learning mode. */
    STATIC_TASK_LEARNING,
    /** Finds new solutions on its own. */
    DYNAMIC_TASK_LEARNING
  }

  /** Level of independence from people (thesis 2.3.3). */
  public enum Independence implements Level {
    /** None: remotely controlled. */
    TELEOPERATION,
    /** Simple tasks, such as straight and level flight. */
    STABILIZED,
    /** Its task, once people have started it. */
    TASK_AUTONOMY,
    /** As before, and it reports its condition. */
    HEALTH_REPORTING,
    /** Diagnoses its faults, reacts to them, and refuses tasks that it cannot do. */
    PROBLEM_DETECTION,
    /** Finds the resources it needs, avoids danger and repairs itself. */
    SELF_PRESERVATION
  }

  /**
   * Reads {@code <autonomy perception="2" decision="static response" independence="5"/>}: levels by
   * number or name.
   *
   * @throws org.u2sa.interfaces.BadInputException naming file, line, value and what was expected
   */
  static AutonomyLevels read(XmlElement element) {
    element.refuseUnknownAttributes("perception", "decision", "independence");
    element.refuseUnknownChildren();
    element.refuseText();
    return new AutonomyLevels(
        level(element, "perception", Perception.values()),
        level(element, "decision", Decision.values()),
        level(element, "independence", Independence.values()));
  }

  private static <L extends Level> L level(XmlElement element, String attribute, L[] levels) {
    String text = element.attribute(attribute);
    String plain = text.toLowerCase(Locale.ROOT).replaceAll("[ _-]+", " ").trim();
    List<String> names = new ArrayList<>();
    for (L level : levels) {
      if (plain.equals(level.words()) || plain.equals(String.valueOf(level.number()))) {
        return level;
      }
      names.add(level.number() + " " + level.words());
    }
    List<String> words = Stream.of(levels).map(Level::words).collect(Collectors.toList());
    throw element.error(
        String.format(
            "%s: \"%s\" is not a level; expected one of %s%s",
            attribute, text, String.join(", ", names), NearestNames.didYouMean(plain, words)));
  }
}
