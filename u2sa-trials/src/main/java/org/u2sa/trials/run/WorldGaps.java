package org.u2sa.trials.run;

import java.util.List;
import java.util.function.Consumer;
import org.u2sa.world.xml.WorldFile;

/** Tells what a simulation leaves out of a world file, above all possible obstacles. */
public final class WorldGaps {
  private static final int MAX_LINES = 20; // each of obstacles and of others

  private WorldGaps() {}

  /** Prints a line for each element that is left out, with warnings first. */
  public static void tell(WorldFile world, Consumer<String> console) {
    List<String> missing = world.missing();
    tell("WARNING: not in the world, but possibly in the way: ", missing, console);
    tell(
        "Not in the world: ",
        world.ignored().stream().filter(words -> !missing.contains(words)).toList(),
        console);
  }

  private static void tell(String start, List<String> elements, Consumer<String> console) {
    elements.stream().limit(MAX_LINES).forEach(words -> console.accept(start + words));
    if (elements.size() > MAX_LINES) {
      console.accept(start + (elements.size() - MAX_LINES) + " more; see u2sa world check");
    }
  }
}
