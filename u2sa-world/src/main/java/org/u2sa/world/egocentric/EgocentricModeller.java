package org.u2sa.world.egocentric;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.Sighting;

/**
 * Remembers stationary objects relative to the vehicle, without a State Estimator (thesis 4.3.2):
 * each sighting corrects an object's place, and between sightings turn rate and speed, as IMU and
 * velocity log measure them, carry it along. Objects are published in BODY, as of a level vehicle.
 */
public final class EgocentricModeller implements Modeller {
  private static final double LEAST_SHARE = 0.1; // of a sighting in the place

  private record Variables(
      @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 20)
          @Description("EGOCENTRIC: time after its last sighting at which an object is dropped.")
          double egocentricMemory,
      @Variable(unit = "m", min = 0.01, max = 1000, ifAbsent = 1.5)
          @Description(
              "EGOCENTRIC: distance within which a sighting is an object of its type that is known, plus an eighth of the range.")
          double egocentricGate) {}

  /** An object, with its place relative to the level vehicle: forward, left, down [m]. */
  private static final class Remembered {
    private ObjectDescription seen;
    private Point place;
    private int sightings = 1;
    private long seenMicros;

    Remembered(ObjectDescription seen, Point place, long seenMicros) {
      this.seen = seen;
      this.place = place;
      this.seenMicros = seenMicros;
    }

    void see(ObjectDescription object, Point at, boolean isUnsure, long micros) {
      sightings++;
      double share = isUnsure ? 1.0 : Math.max(LEAST_SHARE, 1.0 / sightings);
      place = place.plus(at.minus(place).times(share));
      seen = object;
      seenMicros = micros;
    }
  }

  private final Settings<Variables> tuning;
  private final OwnMotion motion = new OwnMotion();
  private final List<Remembered> all = new ArrayList<>();
  private long movedMicros = Long.MIN_VALUE; // time of the places

  /**
   * @param configuration configuration of the World Modeler
   */
  public EgocentricModeller(Configurator configuration) {
    tuning = configuration.settings(Variables.class);
  }

  @Override
  public boolean needsSensedState() {
    return true;
  }

  @Override
  public void sensed(StateInformation measured) {
    if (measured.timestamp().isPresent()) {
      long micros = measured.timestamp().getAsLong();
      moveTo(micros);
      motion.sensed(measured, micros);
    }
  }

  private void moveTo(long micros) {
    if (movedMicros != Long.MIN_VALUE && micros > movedMicros) {
      double seconds = Clock.seconds(micros - movedMicros);
      all.forEach(each -> each.place = motion.after(each.place, seconds, micros));
    }
    movedMicros = Math.max(movedMicros, micros);
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    moveTo(sighting.micros());
    double agoS = Clock.seconds(movedMicros - sighting.micros());
    List<Remembered> free = new ArrayList<>(all);
    for (ObjectDescription each : seen) {
      if (each.referenceFrame().equals(ReferenceFrame.BODY)) {
        Point at = motion.after(motion.level(each.center()), agoS, movedMicros);
        boolean isUnsure = isUnsure(each);
        Optional<Remembered> known = nearest(free, each.objectType(), at, isUnsure);
        if (known.isPresent()) {
          known.get().see(each, at, isUnsure, sighting.micros());
          free.remove(known.get());
        } else {
          all.add(new Remembered(each, at, sighting.micros()));
        }
      }
    }
  }

  /** Whether only the direction is measured: then the newest sighting counts, and one object. */
  private boolean isUnsure(ObjectDescription object) {
    double mostM = tuning.get().egocentricGate();
    return object
        .motion()
        .sigma()
        .filter(sigma -> Math.max(Math.max(sigma.x(), sigma.y()), sigma.z()) > mostM)
        .isPresent();
  }

  private Optional<Remembered> nearest(
      List<Remembered> free, String type, Point at, boolean isUnsure) {
    double gateM =
        isUnsure
            ? Double.POSITIVE_INFINITY
            : tuning.get().egocentricGate() + at.distance() / 8.0;
    return free.stream()
        .filter(each -> each.seen.objectType().equals(type))
        .filter(each -> each.place.distanceTo(at) < gateM)
        .min(Comparator.comparingDouble(each -> each.place.distanceTo(at)));
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    long oldest = now.micros() - Clock.micros(tuning.get().egocentricMemory());
    all.removeIf(each -> each.seenMicros < oldest);
    double sinceS = Math.max(0.0, Clock.seconds(now.micros() - movedMicros));
    List<ObjectDescription> objects = new ArrayList<>();
    for (Remembered each : all) {
      Point place = motion.after(each.place, sinceS, now.micros());
      objects.add(each.seen.copy().x(place.x()).y(place.y()).z(place.z()));
    }
    return objects;
  }

  @Override
  public String remark() {
    return all.size() + " objects remembered" + (isCarried() ? "" : "; speed unknown");
  }

  private boolean isCarried() {
    return motion.knowsSpeed(movedMicros);
  }
}
