package org.u2sa.world.bearing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.Sighting;

/**
 * Locates stationary objects whose direction alone is measured, such as pingers, by the
 * intersection of lines of sight. Without the vehicle's state, the newest sighting is published in
 * BODY for a while. Expects one object per type.
 */
public final class BearingModeller implements Modeller {
  private record Variables(
      @Variable(ifAbsentText = "pinger")
          @Description(
              "BEARINGS: types of objects whose direction alone is measured, separated by commas; name them in UNMAPPED TYPES as well.")
          String bearingTypes,
      @Variable(unit = "rad", min = 0.0001, max = 1, ifAbsent = 0.05)
          @Description("BEARINGS: standard deviation of a direction.")
          double bearingSigma,
      @Variable(min = 2, max = 1000, ifAbsent = 60)
          @Description("BEARINGS: number of newest directions that locate an object.")
          int bearingCount,
      @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 5)
          @Description("BEARINGS: time after the last sighting at which an object is dropped.")
          double bearingMemory) {}

  private final Settings<Variables> tuning;
  private final Map<String, Deque<BearingLine>> lines = new TreeMap<>(); // by type
  private final Map<String, ObjectDescription> newest = new TreeMap<>(); // by type
  private MapFrame frame = MapFrame.BODY;

  /**
   * @param configuration configuration of the World Modeler
   */
  public BearingModeller(Configurator configuration) {
    tuning = configuration.settings(Variables.class);
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    for (ObjectDescription each : seen) {
      if (each.referenceFrame().isBody() && isOfTypes(each)) {
        newest.put(each.objectType(), each);
        if (!frame.frame().isBody() && sighting.vehicle().isPresent()) {
          remember(each, sighting);
        }
      }
    }
  }

  private boolean isOfTypes(ObjectDescription object) {
    return Arrays.stream(tuning.get().bearingTypes().split(","))
        .anyMatch(type -> type.trim().equals(object.objectType()));
  }

  private void remember(ObjectDescription object, Sighting sighting) {
    Point frd = object.in(ReferenceFrame.BODY_FRD, null).center();
    double range = frd.distance();
    if (range > 0.0) {
      Deque<BearingLine> known =
          lines.computeIfAbsent(object.objectType(), type -> new ArrayDeque<>());
      Point direction = frame.mapFromFrd(sighting.vehicle()).times(frd.times(1.0 / range));
      known.addLast(new BearingLine(frame.vehicle(sighting.vehicle()), direction, range));
      while (known.size() > tuning.get().bearingCount()) {
        known.removeFirst();
      }
    }
  }

  @Override
  public void enter(MapFrame newFrame, Sighting now) {
    frame = newFrame;
    lines.clear();
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    long oldest = now.micros() - Clock.micros(tuning.get().bearingMemory());
    newest.values().removeIf(object -> object.timestamp().orElse(oldest) < oldest);
    List<ObjectDescription> all = new ArrayList<>();
    newest.forEach((type, object) -> all.add(located(type).orElse(object)));
    return all;
  }

  /** The object at the intersection of its lines; empty without lines. */
  private Optional<ObjectDescription> located(String type) {
    Deque<BearingLine> known = lines.getOrDefault(type, new ArrayDeque<>());
    if (known.isEmpty()) {
      return Optional.empty();
    }
    BearingLine.Meeting meeting = BearingLine.of(known, tuning.get().bearingSigma());
    Point place = frame.point(meeting.place());
    ObjectDescription object = newest.get(type).copy();
    object.referenceFrame(frame.frame()).x(place.x()).y(place.y()).z(place.z());
    object.motion().sigma(meeting.sigma());
    return Optional.of(object);
  }

  @Override
  public String remark() {
    StringBuilder text = new StringBuilder();
    lines.forEach(
        (type, known) ->
            text.append(
                String.format(
                    Locale.ROOT,
                    "%s by %d directions, off by %.1f sigma; ",
                    type,
                    known.size(),
                    BearingLine.of(known, tuning.get().bearingSigma()).residual())));
    return text.length() == 0 ? "no directions yet" : text.substring(0, text.length() - 2);
  }
}
