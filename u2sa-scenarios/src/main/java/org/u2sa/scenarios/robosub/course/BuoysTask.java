package org.u2sa.scenarios.robosub.course;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;

/**
 * Buoys to be bumped in order.
 *
 * @param places positions of the buoys, in this order
 * @param colours colours of the buoys
 */
record BuoysTask(List<Point> places, List<Colour> colours) implements CourseTask {
  private List<String> types() {
    return colours.stream()
        .map(colour -> SubObjects.type(colour, "buoy"))
        .collect(Collectors.toList());
  }

  @Override
  public List<ObjectDescription> objects() {
    List<ObjectDescription> objects = new ArrayList<>();
    for (int i = 0; i < places.size(); i++) {
      Buoy buoy = new Buoy().colour(colours.get(i)).radius(0.15);
      objects.add(SubObjects.placed(buoy, types().get(i), places.get(i)));
    }
    return objects;
  }

  @Override
  public List<Goal> goals() {
    return types().stream()
        .map(type -> new Goal("bumpBuoy", type, List.of(type)))
        .collect(Collectors.toList());
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private final List<String> bumped = new ArrayList<>();

    @Override
    public void touched(String uid) {
      if (types().contains(uid) && !bumped.contains(uid)) {
        bumped.add(uid);
      }
    }

    private int inOrder() {
      int count = 0;
      while (count < bumped.size() && bumped.get(count).equals(types().get(count))) {
        count++;
      }
      return count;
    }

    @Override
    public Optional<String> violation() {
      return inOrder() == types().size()
          ? Optional.empty()
          : Optional.of("buoys: expected " + types() + ", bumped " + bumped);
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of("buoysBumpedInOrder", inOrder());
    }
  }
}
