package org.u2sa.world.sdf;

import java.util.ArrayList;
import java.util.List;

/** Elements of a world that do not become objects, or not where they are, and why. */
final class SdfOmissions {
  private final List<String> all = new ArrayList<>();
  private final List<String> obstacles = new ArrayList<>();

  /** Adds an element that stands in nobody's way, such as the ground plane. */
  void harmless(String words) {
    all.add(words);
  }

  /** Adds an element that may stand in the way. */
  void obstacle(String words) {
    all.add(words);
    obstacles.add(words);
  }

  /** All elements, in the order in which they were read. */
  List<String> all() {
    return List.copyOf(all);
  }

  /** Those that may stand in the way. */
  List<String> obstacles() {
    return List.copyOf(obstacles);
  }
}
