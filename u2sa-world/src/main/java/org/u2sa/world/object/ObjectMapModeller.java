package org.u2sa.world.object;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.grid.GridModeller;
import org.u2sa.world.modeller.HiddenGround;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Maintains a map of objects over time (thesis 4.1.1.2): associates sightings with known objects,
 * confirms objects seen repeatedly, tracks moving ones, and drops those that are no longer seen
 * where they should be.
 */
public final class ObjectMapModeller implements Modeller {
  /** Maximum length of a UID to which a number may be appended. */
  private static final int MAX_NUMBERED_CHARS = 900;

  /** Fraction of the heap for remembered sightings from other processes. */
  private static final int HEAP_PART = 4;

  private static final int MAX_SENSORS = 64; // caps memory against spoofed sensors
  private static final long MIN_SIGHTING_BYTES = 8L << 10; // size of an outline of a hundred points

  private final Settings<ObjectMapVariables> settings;
  private final Settings<GridModeller.Variables> heights;
  private final List<MappedObject> tracks = new ArrayList<>();
  private final TrackReport report = new TrackReport();
  private final HiddenGround hidden = new HiddenGround();
  private final ScannedMovers scanned = new ScannedMovers();
  private final NewestClouds clouds = new NewestClouds();
  private final Set<String> heard = new TreeSet<>(); // sensors, also by the names of their parts
  private List<ObjectDescription> known = List.of();
  private long knownMicros;
  private MapFrame frame = MapFrame.BODY;
  private long sightings;
  private long unplaced;
  private long misread;
  private long absurd;
  private long tooLong;

  public ObjectMapModeller(Configurator configuration) {
    settings = configuration.settings(ObjectMapVariables.class);
    heights = configuration.settings(GridModeller.Variables.class);
  }

  @Override
  public void objects(List<ObjectDescription> all, Sighting sighting) {
    List<ObjectDescription> objects = new ArrayList<>();
    for (ObjectDescription each : all) {
      if (!NewestClouds.takes(each)) {
        objects.add(each);
      } else if (!settings.get().isUnmapped(each.objectType())) {
        clouds.put((PointCloud) each, sighting);
      }
    }
    if (!objects.isEmpty()) {
      if (heard.size() < MAX_SENSORS) {
        heard.add(objects.get(0).sensorName());
        heard.add(SensorParts.sensor(objects.get(0).sensorName()));
      }
      take(objects, sighting, MappedObject.Source.SENSOR);
    }
  }

  private void take(List<ObjectDescription> all, Sighting sighting, MappedObject.Source source) {
    ObjectMapVariables tuning = settings.get();
    List<ObjectDescription> seen =
        all.stream()
            .filter(each -> !tuning.isUnmapped(each.objectType()) && isShort(each, tuning))
            .collect(Collectors.toList());
    Point at = sighting.frame().vehicle(sighting.vehicle());
    hidden.lookFrom(at.x(), at.y(), sighting.micros());
    List<Detection> detections = new ArrayList<>();
    for (ObjectDescription each : seen) {
      Optional<Detection> placed = Detection.of(each, sighting, tuning.defaultSigma());
      placed
          .filter(detection -> !isHidden(each, detection.place(), tuning))
          .ifPresent(detections::add);
      unplaced += placed.isPresent() ? 0 : 1;
    }
    sightings += seen.size();
    tracks.forEach(track -> track.predict(sighting.micros(), tuning));
    int[] match = new SightingMatch(tracks, tuning).of(detections);
    String sensor = all.get(0).sensorName();
    Set<MappedObject> hit = new HashSet<>();
    for (int i = 0; i < match.length; i++) {
      if (match[i] != SightingMatch.NONE) {
        MappedObject track = tracks.get(match[i]);
        if (!track.hit(detections.get(i), sighting.micros(), source, tuning)) {
          misread++;
          continue;
        }
        track.judge(tuning.confirmHits(), tuning.confirmWindow());
        hit.add(track);
      }
    }
    lookFor(sensor, hit, sighting, tuning);
    for (int i = 0; i < match.length; i++) {
      if (match[i] == SightingMatch.NONE
          && tracks.size() - known.size() < 2 * tuning.maxObjects()) {
        begin(detections.get(i), sighting.micros(), tuning, source);
      }
    }
    tidy(sighting.micros(), tuning);
  }

  /** Whether this length would fit even for the maximum number of objects. */
  private boolean isShort(ObjectDescription sighting, ObjectMapVariables tuning) {
    long share = Runtime.getRuntime().maxMemory() / HEAP_PART / (2L * tuning.maxObjects());
    boolean isShort = sighting.receivedBytes() <= Math.max(MIN_SIGHTING_BYTES, share);
    tooLong += isShort ? 0 : 1;
    return isShort;
  }

  /** Whether a flat object is hidden by something that a scanner sees. */
  private boolean isHidden(ObjectDescription object, Point place, ObjectMapVariables tuning) {
    return tuning.isFlat(object.objectType())
        && hidden.hides(place.x(), place.y(), Double.POSITIVE_INFINITY);
  }

  private MappedObject begin(
      Detection detection, long micros, ObjectMapVariables tuning, MappedObject.Source source) {
    MappedObject track =
        new MappedObject(freeUid(detection.object().uid()), detection, micros, tuning, source);
    track.occasion(1);
    track.judge(tuning.confirmHits(), tuning.confirmWindow());
    tracks.add(track);
    return track;
  }

  /** The sensor's UID, with a number appended if another object has it. */
  private String freeUid(String wanted) {
    Set<String> taken = new HashSet<>();
    tracks.forEach(track -> taken.add(track.uid()));
    String base = wanted.length() <= MAX_NUMBERED_CHARS ? wanted : "object";
    String uid = wanted;
    for (int n = 2; taken.contains(uid); n++) {
      uid = base + " " + n;
    }
    return uid;
  }

  /** Counts against objects that this sensor should have seen but did not. */
  private void lookFor(
      String sensor, Set<MappedObject> hit, Sighting sighting, ObjectMapVariables tuning) {
    FieldOfView field =
        SensorParts.value(FieldOfView.parse(tuning.fieldsOfView()), sensor).orElse(null);
    for (MappedObject track : tracks) {
      if (hit.contains(track) || isHidden(track.template(), place(track), tuning)) {
        continue;
      }
      if (field != null && field.sees(fromVehicle(place(track), sighting))) {
        track.miss(tuning);
      } else if (field == null
          && !track.isConfirmed()
          && track.template().sensorName().equals(sensor)) {
        track.occasion(0);
      }
    }
  }

  /** Position in map coordinates [m]; moving objects of the file follow their own course. */
  private Point place(MappedObject track) {
    return track.isFromFile() ? frame.metres(track.template().center()) : track.place();
  }

  private static Point fromVehicle(Point place, Sighting sighting) {
    MapFrame map = sighting.frame();
    if (map.frame().isBody()) {
      return Point.of(place.x(), -place.y(), place.z());
    }
    Point way = place.minus(map.vehicle(sighting.vehicle()));
    return map.mapFromFrd(sighting.vehicle()).transposed().times(way);
  }

  @Override
  public void scan(RangeScan scan, ScanPoses poses) {
    ObjectMapVariables tuning = settings.get();
    if (!tuning.flatTypes().trim().isEmpty()) {
      hidden.scan(scan, poses.at(scan, 0.5), poses.first().frame().up(), poses.first().micros());
    }
    ScanThrough through = null;
    for (MappedObject track : tracks) {
      boolean shown =
          scan.sensorName().equals(track.template().sensorName())
              || tuning.scannerSees(track.template().objectType());
      if (shown) {
        through = through == null ? new ScanThrough(scan, poses.at(scan, 0.5)) : through;
        Point sigma = track.filter().sigma();
        double radius = track.radius() + Math.max(sigma.x(), sigma.y());
        if (through.passed(place(track), radius)) {
          track.miss(tuning);
        }
      }
    }
    if (tuning.moversInScans()) {
      List<ObjectDescription> moving = scanned.of(scan, poses, heights.get().band());
      if (!moving.isEmpty()) {
        take(moving, poses.first(), MappedObject.Source.ECHOES);
      }
    }
    tidy(poses.first().micros(), tuning);
  }

  private void tidy(long micros, ObjectMapVariables tuning) {
    tracks.removeIf(track -> track.isGone(tuning, micros));
    for (int i = 0; i < tracks.size(); i++) {
      for (int k = tracks.size() - 1; k > i; k--) {
        if (areOne(tracks.get(i), tracks.get(k), tuning)) {
          tracks.get(i).absorb(tracks.remove(k)); // the older one keeps its UID
        }
      }
    }
    List<MappedObject> surest = new ArrayList<>(tracks);
    surest.removeIf(MappedObject::isFromFile); // file objects are exempt from the limit
    if (surest.size() > tuning.maxObjects()) {
      surest.sort(Comparator.comparingDouble(track -> -track.existence())); // stable
      tracks.removeAll(new HashSet<>(surest.subList(tuning.maxObjects(), surest.size())));
    }
  }

  private static boolean areOne(MappedObject a, MappedObject b, ObjectMapVariables tuning) {
    if (!a.isConfirmed() || !b.isConfirmed()) {
      return false;
    }
    if (a.isFromFile()) {
      return !b.isFromFile()
          && a.isLike(b.template(), tuning.trustUids())
          && !(a.isFixture() && b.filter().isMoving())
          && a.template().distanceTo(b.template().center()) < tuning.mergeWithin();
    }
    return a.place().minus(b.place()).distance() < tuning.mergeWithin() // rules most pairs out
        && a.isLike(b.template(), tuning.trustUids())
        && a.filter().distance(b.place(), b.filter().sigma()) < tuning.gate() * tuning.gate();
  }

  @Override
  public void known(List<ObjectDescription> objects, Sighting now) {
    known = List.copyOf(objects);
    knownMicros = now.micros();
    tracks.removeIf(MappedObject::isFromFile);
    enterKnown(now);
  }

  private void enterKnown(Sighting now) {
    int at = 0;
    for (ObjectDescription object : known) {
      Optional<Detection> placed = Detection.of(object, now, 0.0);
      if (placed.isPresent()) {
        tracks.add(
            at++,
            new MappedObject(
                freeUid(object.uid()),
                placed.get(),
                knownMicros,
                settings.get(),
                MappedObject.Source.FILE));
      }
    }
  }

  @Override
  public void enter(MapFrame newFrame, Sighting now) {
    scanned.clear();
    clouds.clear();
    List<MappedObject> before = new ArrayList<>(tracks);
    Sighting there = new Sighting(now.micros(), newFrame, now.vehicle());
    tracks.clear();
    for (MappedObject track : before) {
      if (!track.isFromFile()) {
        ObjectDescription object = report.estimate(track, frame);
        Optional<Detection> placed = Detection.of(object, there, settings.get().defaultSigma());
        placed.ifPresent(
            detection -> {
              track.replace(detection, settings.get());
              tracks.add(track);
            });
      }
    }
    frame = newFrame;
    enterKnown(new Sighting(now.micros(), newFrame, Optional.empty()));
  }

  @Override
  public boolean publishesKnown() {
    return true;
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    ObjectMapVariables tuning = settings.get();
    tidy(now.micros(), tuning);
    List<ObjectDescription> objects = new ArrayList<>();
    for (MappedObject track : List.copyOf(tracks)) {
      if (track.isConfirmed() && track.isShown()) {
        try {
          track.predict(now.micros(), tuning);
          objects.add(report.of(track, frame, tuning, now.micros()));
        } catch (IllegalArgumentException e) { // values out of range: absurd sightings
          tracks.remove(track);
          absurd++;
        }
      }
    }
    objects.addAll(clouds.clouds(now, tuning.forgetStanding()));
    for (ObjectDescription object : known) { // objects that cannot be converted to this frame
      if (frame.placed(object, now.vehicle()).isEmpty()) {
        objects.add(object.after(Clock.seconds(now.micros() - knownMicros)));
      }
    }
    return objects;
  }

  @Override
  public String remark() {
    long confirmed = tracks.stream().filter(MappedObject::isConfirmed).count();
    long moving = tracks.stream().filter(track -> track.filter().isMoving()).count();
    return String.format(
            "%s objects, %s confirmed, %s moving, %s sightings, %s not convertible to %s, %s of a"
                + " name in the wrong place",
            tracks.size(), confirmed, moving, sightings, unplaced, frame.frame(), misread)
        + clouds.remark()
        + (absurd == 0 ? "" : ", " + absurd + " dropped for implausible values")
        + (tooLong == 0 ? "" : ", " + tooLong + " rejected for their length")
        + unheard();
  }

  /** Names sensors in FIELDS OF VIEW without sightings: a misspelt one would have no effect. */
  private String unheard() {
    Set<String> unheard = new TreeSet<>(FieldOfView.parse(settings.get().fieldsOfView()).keySet());
    unheard.removeAll(heard);
    return heard.isEmpty() || unheard.isEmpty()
        ? ""
        : ", no sightings from " + unheard + " in FIELDS OF VIEW, only from " + heard;
  }

  @Override
  public void handOver(HandOver state, Sighting now) {
    List<ObjectDescription> objects = new ArrayList<>();
    for (MappedObject track : tracks) {
      if (track.isConfirmed() && track.isShown() && !track.isFromFile()) {
        objects.add(report.estimate(track, frame));
      }
    }
    state.messages("OBJECTS", objects);
  }

  @Override
  public void takeOver(HandOver state, Sighting now) {
    StateInformation vehicle = now.vehicle().orElse(null);
    for (ObjectDescription object : state.messages("OBJECTS", ObjectDescription.class)) {
      if (NewestClouds.takes(object)) {
        continue; // remembered by the predecessor, soon replaced by a new scan
      }
      Sighting sighting = new Sighting(now.micros(), frame, Optional.ofNullable(vehicle));
      Detection.of(object, sighting, settings.get().defaultSigma())
          .ifPresent(
              detection ->
                  begin(detection, now.micros(), settings.get(), MappedObject.Source.SENSOR)
                      .confirm());
    }
  }
}
