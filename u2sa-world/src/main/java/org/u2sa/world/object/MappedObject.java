package org.u2sa.world.object;

import java.util.HashMap;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;

/** One object of the map: type, position and probability of existence. */
final class MappedObject {
  /** Origin of an object. */
  enum Source {
    FILE,
    /** A sensor that detects objects. */
    SENSOR,
    /** Echoes of a scanner in formerly free space. */
    ECHOES
  }

  private static final double FALSE_ALARM = 0.1; // probability that a sighting is false
  private static final double NEW = 0.5;
  private static final double SUREST = 0.999;
  private static final double GONE = 0.05;
  private static final int BELIEVED_AFTER = 4;
  private static final int MAX_SENSORS = 32; // number of sensors whose UIDs are kept

  private final String uid;
  private final boolean fromFile;
  private final Map<String, String> sensorUids = new HashMap<>(); // UID given by each sensor
  private TrackFilter filter;
  private ObjectDescription template; // newest sighting, in the map's frame
  private double radius;
  private double existence = NEW;
  private int seen; // bit set of the last opportunities, newest in bit 0
  private int occasions;
  private boolean confirmed;
  private boolean moved;
  private boolean scanned; // known only from scanner echoes
  private int implausible; // consecutive sightings
  private long filteredMicros;
  private long seenMicros;

  MappedObject(
      String uid, Detection first, long micros, ObjectMapVariables settings, Source source) {
    this.uid = uid;
    fromFile = source == Source.FILE;
    scanned = source == Source.ECHOES;
    filter = filter(first, settings);
    filteredMicros = micros;
    see(first, micros);
    confirmed = fromFile;
    existence = fromFile ? SUREST : NEW;
  }

  private static TrackFilter filter(Detection at, ObjectMapVariables settings) {
    return new TrackFilter(
        at.place(),
        at.sigma(),
        at.velocity(),
        at.velocitySigma(),
        settings.assumptions(at.object().objectType()));
  }

  /** Whether it is published. Stationary echoes are not: the grid shows them already. */
  boolean isShown() {
    return fromFile || !scanned || moved;
  }

  /** Predicts the estimate to a time; earlier times are ignored. */
  void predict(long micros, ObjectMapVariables settings) {
    if (micros > filteredMicros) {
      double seconds = Clock.seconds(micros - filteredMicros);
      if (!fromFile) {
        filter.predict(seconds);
        boolean lost = micros - seenMicros > Clock.micros(settings.forgetMoving());
        if (lost && settings.forgetMoving() > 0.0 && !filter.isMoving()) {
          filter.settle();
        }
      } else if (template.motion().velocity().isPresent()) {
        template = template.after(seconds); // traffic from the file
      }
      filteredMicros = micros;
    }
  }

  /**
   * Updates it with a sighting, unless the UID seems misread because the sighting is farther away
   * than the object can have moved since it was last seen. If such sightings recur, they are
   * accepted.
   *
   * @return whether it was accepted
   */
  boolean hit(Detection detection, long micros, Source source, ObjectMapVariables settings) {
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

  private boolean isNear(Detection detection, Point reach, ObjectMapVariables settings) {
    Point sigma = detection.sigma();
    Point wider =
        Point.of(
            Math.hypot(sigma.x(), reach.x()),
            Math.hypot(sigma.y(), reach.y()),
            Math.hypot(sigma.z(), reach.z()));
    return filter.distance(detection.place(), wider) <= settings.gate() * settings.gate();
  }

  /** Distance it can have moved since it was last seen, 1 sigma per axis [m]. */
  private Point reach(long micros, ObjectMapVariables settings) {
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
    String sensor = detection.object().sensorName();
    boolean hasRoom = sensorUids.size() < MAX_SENSORS || sensorUids.containsKey(sensor);
    if (!sensor.isEmpty() && hasRoom) {
      sensorUids.put(sensor, detection.object().uid());
    }
    seenMicros = Math.max(seenMicros, micros);
  }

  /** Adds the known type to a sighting: scanners measure positions, cameras types. */
  private ObjectDescription knownAs(ObjectDescription newest) {
    if (!newest.objectType().isEmpty() || template.objectType().isEmpty()) {
      return newest;
    }
    ObjectDescription known = newest.copy().objectType(template.objectType());
    template.level().filter(level -> !newest.level().isPresent()).ifPresent(known::level);
    return known;
  }

  /**
   * Records that a sensor covering its position did not see it. Objects of the world file are
   * unaffected unless doubts are allowed, because not every sensor sees everything in a map.
   */
  void miss(ObjectMapVariables settings) {
    if (fromFile && !settings.doubtFile()) {
      return;
    }
    occasion(0);
    double detection = settings.detectionProbability();
    existence = existence * (1.0 - detection) / (1.0 - existence * detection);
  }

  /** Records whether it was seen (1) or not (0) at an opportunity. */
  void occasion(int was) {
    seen = seen << 1 | was;
    occasions++;
  }

  /** Confirms it if it was seen at this many of the last opportunities. */
  void judge(int hits, int window) {
    confirmed |= Integer.bitCount(seen & mask(window)) >= hits;
  }

  private static int mask(int window) {
    return window >= Integer.SIZE ? -1 : (1 << window) - 1;
  }

  /** Whether it failed to be confirmed, is too old, or no longer exists. */
  boolean isGone(ObjectMapVariables settings, long nowMicros) {
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

  /** Whether it comes from a file, without a velocity. */
  boolean isFixture() {
    return fromFile && template.motion().velocity().isEmpty();
  }

  /** Whether type and UID of a sighting are compatible with this object. */
  boolean isLike(ObjectDescription other, boolean trustUids) {
    String mine = template.objectType();
    boolean types =
        mine.isEmpty() || other.objectType().isEmpty() || mine.equals(other.objectType());
    String named = sensorUids.get(other.sensorName());
    return types && (!trustUids || named == null || named.equals(other.uid()));
  }

  /** Whether this sensor has used this UID for it before. */
  boolean isCalled(ObjectDescription other) {
    return other.uid().equals(sensorUids.get(other.sensorName()));
  }

  /** Merges UIDs, time and existence of another track of the same object. */
  void absorb(MappedObject other) {
    if (sensorUids.size() + other.sensorUids.size() <= MAX_SENSORS) {
      other.sensorUids.forEach(sensorUids::putIfAbsent);
    }
    seenMicros = Math.max(seenMicros, other.seenMicros);
    existence = Math.max(existence, other.existence);
  }

  /** Restarts the filter at a new position, e.g. in another map frame. */
  void replace(Detection placed, ObjectMapVariables settings) {
    filter = filter(placed, settings);
    template = placed.object();
  }

  /** Confirms an object restored from another modeller. */
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

  boolean hasMoved() {
    return moved;
  }

  TrackFilter filter() {
    return filter;
  }

  ObjectDescription template() {
    return template;
  }

  /** Radius [m]. */
  double radius() {
    return radius;
  }

  double existence() {
    return existence;
  }

  /** Position in map coordinates [m]. */
  Point place() {
    return filter.place();
  }
}
