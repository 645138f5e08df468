package org.u2sa.mission;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.service.handover.HandOver;

/** Position in a {@link GoalSequence}, by goal names only. Not thread-safe. */
final class Position {
  final Set<String> current = new LinkedHashSet<>();
  final Set<String> pending = new LinkedHashSet<>(); // follow when the current goals are finished
  final Set<String> finished = new LinkedHashSet<>(); // in this lap
  final Map<String, Long> repeats = new LinkedHashMap<>(); // start time of the goals in progress

  /**
   * Number of current goals that must still be completed, no matter which; 0: as given by the
   * options.
   */
  long wanted;

  /** Whether a goal that was current beside these ended the mission, if nothing is pending. */
  boolean ends;

  Position() {}

  Position(Position other) {
    current.addAll(other.current);
    pending.addAll(other.pending);
    finished.addAll(other.finished);
    repeats.putAll(other.repeats);
    wanted = other.wanted;
    ends = other.ends;
  }

  void handOver(HandOver state, String name) {
    state
        .texts(name + " CURRENT", current)
        .texts(name + " PENDING", pending)
        .texts(name + " FINISHED", finished)
        .texts(name + " REPEATS", texts(repeats))
        .number(name + " WANTED", wanted)
        .flag(name + " ENDS", ends);
  }

  static Position takenOver(HandOver state, String name) {
    Position position = new Position();
    position.current.addAll(state.texts(name + " CURRENT"));
    position.pending.addAll(state.texts(name + " PENDING"));
    position.finished.addAll(state.texts(name + " FINISHED"));
    position.repeats.putAll(numbers(state.texts(name + " REPEATS")));
    position.wanted = (long) state.number(name + " WANTED").orElse(0.0);
    position.ends = state.flag(name + " ENDS");
    return position;
  }

  /** Numbers by name as texts: "3 gate". */
  static List<String> texts(Map<String, Long> numbers) {
    List<String> texts = new ArrayList<>();
    numbers.forEach((name, number) -> texts.add(number + " " + name));
    return texts;
  }

  /**
   * @throws IllegalArgumentException if one is not in the format of {@link #texts}
   */
  static Map<String, Long> numbers(List<String> texts) {
    Map<String, Long> numbers = new LinkedHashMap<>();
    for (String text : texts) {
      String[] parts = text.split(" ", 2);
      if (parts.length != 2) {
        throw new IllegalArgumentException("\"" + text + "\": expected a number and a goal's name");
      }
      numbers.put(parts[1], Long.parseLong(parts[0]));
    }
    return numbers;
  }
}
