package org.u2sa.scenarios.vrx.sight;

import java.util.Map;
import java.util.TreeMap;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.PlannerView;

/** The signs of a dock's bays in the world model. */
public final class SeenSigns {
  private SeenSigns() {}

  /**
   * Signs by type. If a sign has several tracks, the most certain one counts; the others are old
   * sightings.
   */
  public static Map<String, Point> of(PlannerView surroundings, StateInformation state) {
    Map<String, ObjectDescription> surest = new TreeMap<>();
    for (ObjectDescription object : surroundings.objects()) {
      if (object.objectType().matches("\\w+ (circle|cross|triangle|rectangle)")) {
        surest.merge(object.objectType(), object, (a, b) -> sigmaM(a) <= sigmaM(b) ? a : b);
      }
    }
    Map<String, Point> signs = new TreeMap<>();
    surest.forEach((type, object) -> signs.put(type, surroundings.centre(object, state)));
    return signs;
  }

  private static double sigmaM(ObjectDescription object) {
    return object.motion().sigma().map(Point::distance).orElse(Double.MAX_VALUE);
  }
}
