package org.u2sa.world.object;

import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;

/** One object of the map: what it is, where it is, and how certain it is that it exists. */
final class MappedObject {
  /** Where it is known from. */
  enum Source {
    /** The world file. */
    FILE,
    /** A sensor that makes out objects. */
    SENSOR,
    /** A scanner's echoes where nothing was before. */
    ECHOES
  }

  private static final double FALSE_ALARM = 0.1; // probability that a sighting is of nothing
  private static final double NEW = 0.5;
  private static final double SUREST = 0.999;
  private static final double GONE = 0.05;
  private static final int BELIEVED_AFTER = 4;

  private final String uid;
  private final boolean fromFile;
  private final Map<String, String> sensorUids = new TreeMap<>(); // by sensor
  private TrackFilter filter;
  private ObjectDescription template; // the newest sighting, in the map's frame
  private double radius;
  private double existence = NEW;
  private int seen; // bits of the last occasions, the newest is 1
  private int occasions;
  private boolean confirmed;
  private boolean moved;
  private boolean scanned; // nothing but a scanner's echoes has shown it
  private int implausible; // sightings in a row
  private long filteredMicros;
  private long seenMicros;

  MappedObject(
      String uid, Detection first, long micros, ObjectMapSettings settings, Source source) {
    this.uid = uid;
    fromFile = source == Source.FILE;
    scanned = source == Source.ECHOES;
    filter = filter(first, settings);
    filteredMicros = micros;
    see(first, micros);
    confirmed = fromFile;
    existence = fromFile ? SUREST : NEW;
  }

  private static TrackFilter filter(Detection at, ObjectMapSettings settings) {
    return new TrackFilter(
        at.place(),
        at.sigma(),
        at.velocity(),
        at.velocitySigma(),
        settings.assumptions(at.object().objectType()));
  }

  /** Whether it is more than echoes that stand, of which the grid tells as well. */
  boolean isShown() {
    return fromFile || !scanned || moved;
  }

  /** Carries the estimate on to a time; an earlier one changes nothing. */
  void predict(long micros, ObjectMapSettings settings) {
    if (micros > filteredMicros) {
      double seconds = Clock.seconds(micros - filteredMicros);
      if (!fromFile) {
        filter.predict(seconds);
        boolean lost = micros - seenMicros > Clock.micros(settings.forgetMoving());
        if (lost && settings.forgetMoving() > 0.0 && !filter.isMoving()) {
          filter.settle();
        }
      } else if (template.motion().velocity().isPresent()) {
        template = template.after(seconds); // traffic as the file has it
      }
      filteredMicros = micros;
    }
  }

  /**
   * Takes a sighting of it, unless its name seems misread: it is farther away than the object can
   * have gone since it was seen last. If such sightings come repeatedly, the object is there.
   *
   * @return whether it was taken
   */
  boolean hit(Detection detection, long micros, Source source, ObjectMapSettings settings) {
    if (!fromFile) {
      if (isNear(detection, Point.ORIGIN, settings)) {
        filter.update(
            detection.place(), detection.sigma(), detection.velocity(), detection.velocitySigma());
      } else if (isNear(detection, reach(micros, settings), settings)
          || ++implausible == BELIEVED_AFTER) {
        replace(detection, settings);
      } else {
        return false;
      }
      implausible = 0;
      moved |= filter.isMoving();
    }
    scanned &= source == Source.ECHOES;
    see(detection, micros);
    occasion(1);
    double probability = settings.detectionProbability();
    existence =
        existence * probability / (existence * probability + (1.0 - existence) * FALSE_ALARM);
    existence = Math.min(SUREST, existence);
    return true;
  }

  private boolean isNear(Detection detection, Point reach, ObjectMapSettings settings) {
    Point sigma = detection.sigma();
    Point wider =
        Point.of(
            Math.hypot(sigma.x(), reach.x()),
            Math.hypot(sigma.y(), reach.y()),
            Math.hypot(sigma.z(), reach.z()));
    return filter.distance(detection.place(), wider) <= settings.gate() * settings.gate();
  }

  /** How far it can have gone since it was seen last, 1 sigma along each axis [m]. */
  private Point reach(long micros, ObjectMapSettings settings) {
    double reach =
        settings.assumptions(template.objectType()).maxSpeed()
            * Math.max(0.0, Clock.seconds(micros - seenMicros));
    return Point.of(reach, reach, reach);
  }

  private void see(Detection detection, long micros) {
    if (!fromFile || template == null) {
      template = template == null ? detection.object() : knownAs(detection.object());
      radius = Extent.radius(template);
    }
    if (!detection.object().sensorName().isEmpty()) {
      sensorUids.put(detection.object().sensorName(), detection.object().uid());
    }
    seenMicros = Math.max(seenMicros, micros);
  }

  /** A sighting as what is known of it: a scanner says where something is, a camera what it is. */
  private ObjectDescription knownAs(ObjectDescription newest) {
    if (!newest.objectType().isEmpty() || template.objectType().isEmpty()) {
      return newest;
    }
    ObjectDescription known = newest.copy().objectType(template.objectType());
    template.level().filter(level -> !newest.level().isPresent()).ifPresent(known::level);
    return known;
  }

  /**
   * Takes note that a sensor looked where it is and did not see it. An object of the world file is
   * as certain as before, unless such objects may be doubted: not every sensor sees what a map has.
   */
  void miss(ObjectMapSettings settings) {
    if (fromFile && !settings.doubtFile()) {
      return;
    }
    occasion(0);
    double detection = settings.detectionProbability();
    existence = existence * (1.0 - detection) / (1.0 - existence * detection);
  }

  /** Takes note that a sensor, of whose field of view nothing is known, saw other things. */
  void occasion(int was) {
    seen = seen << 1 | was;
    occasions++;
  }

  /** Confirms it if it was seen on so many of the last occasions. */
  void judge(int hits, int window) {
    confirmed |= Integer.bitCount(seen & mask(window)) >= hits;
  }

  private static int mask(int window) {
    return window >= Integer.SIZE ? -1 : (1 << window) - 1;
  }

  /** Whether it never became certain and cannot any more, or is known to be gone. */
  boolean isGone(ObjectMapSettings settings, long nowMicros) {
    if (fromFile) {
      return settings.doubtFile() && existence < GONE;
    }
    if (!confirmed && occasions >= settings.confirmWindow()) {
      return true;
    }
    double limit =
        filter.isMoving() || scanned ? settings.forgetMoving() : settings.forgetStanding();
    boolean old = limit > 0.0 && Clock.seconds(nowMicros - seenMicros) > limit;
    return old || existence < GONE;
  }

  /** Whether a sighting may be of this object, by what both are said to be. */
  boolean isLike(ObjectDescription other, boolean trustUids) {
    String mine = template.objectType();
    boolean types =
        mine.isEmpty() || other.objectType().isEmpty() || mine.equals(other.objectType());
    String named = sensorUids.get(other.sensorName());
    return types && (!trustUids || named == null || named.equals(other.uid()));
  }

  /** Whether this sensor has called it by this name before. */
  boolean isCalled(ObjectDescription other) {
    return other.uid().equals(sensorUids.get(other.sensorName()));
  }

  /** Takes over what another track of the same object knows of names. */
  void absorb(MappedObject other) {
    other.sensorUids.forEach(sensorUids::putIfAbsent);
    seenMicros = Math.max(seenMicros, other.seenMicros);
    existence = Math.max(existence, other.existence);
  }

  /** Goes on in another map, where it is as said. */
  void replace(Detection placed, ObjectMapSettings settings) {
    filter = filter(placed, settings);
    template = placed.object();
  }

  /** Certain from the start: taken over from another modeller. */
  void confirm() {
    confirmed = true;
    existence = Math.max(existence, template.confidence().orElse(SUREST));
  }

  String uid() {
    return uid;
  }

  boolean isFromFile() {
    return fromFile;
  }

  boolean isConfirmed() {
    return confirmed;
  }

  /** Whether it was ever seen to move. */
  boolean hasMoved() {
    return moved;
  }

  TrackFilter filter() {
    return filter;
  }

  ObjectDescription template() {
    return template;
  }

  /** [m]. */
  double radius() {
    return radius;
  }

  double existence() {
    return existence;
  }

  long seenMicros() {
    return seenMicros;
  }

  /** Where it is, in metres of the map. */
  Point place() {
    return filter.place();
  }
}
