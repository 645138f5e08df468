package org.u2sa.world.object;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Circle;
import org.u2sa.world.grid.ScanEntry;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.SensorPose;

/**
 * Detects moving objects in the echoes of one scanner: objects no larger than a person or an animal
 * in space that scans of the last seconds saw to be free (Wang, Thorpe, Thrun et al., Simultaneous
 * localization, mapping and moving object tracking, Int. J. Robotics Research 26, 2007, section 5).
 * An object that merely comes into view or range does not qualify, because its space was not
 * observed before. The object map decides whether a detection really moves, and how.
 */
final class MovingEchoes {
  private static final long LOOK_BACK_MICROS = 3 * Clock.MICROS_PER_SECOND;
  private static final long KEEP_EVERY_MICROS = Clock.MICROS_PER_SECOND / 5;
  private static final long REMEMBERED_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final long LOST_MICROS = Clock.MICROS_PER_SECOND;
  private static final double MARGIN_M = 0.15; // scanner and pose errors
  private static final double MARGIN_PER_M = 0.02; // heading error
  private static final int WITNESSES = 2; // earlier scans that saw free space there
  private static final int BEAMS_PAST = 2; // beams between two echoes of one object
  private static final double GAP_M = 0.3; // between two echoes of one object, such as two legs
  private static final int FEWEST = 3; // minimum echoes of an object
  private static final double LARGEST_M = 1.2;
  private static final double NEW_SHARE = 0.3; // minimum fraction of new echoes
  private static final double ROUND = 0.39; // from a disc's mean echo to its centre, in widths
  private static final double SIGMA_M = 0.05;
  private static final double HIDDEN_SIGMA_M = 0.25; // additional sigma of a partly occluded object
  private static final double SMALLEST_RADIUS_M = 0.1;
  private static final double STEP_M = 0.5; // maximum displacement between scans

  /** An object detected before. */
  private static final class Spot {
    private final int number;
    private double x;
    private double y;
    private long seenMicros;
    private long movedMicros;

    Spot(int number) {
      this.number = number;
    }
  }

  private final Deque<Panorama> earlier = new ArrayDeque<>();
  private final List<Spot> spots = new ArrayList<>();
  private final BeamEnds ends = new BeamEnds();
  private int found;

  /** Objects of a scan that move or moved recently, in the map's frame; scans come in order. */
  List<ObjectDescription> of(RangeScan scan, ScanPoses poses, ScanEntry.Band band) {
    MapFrame map = poses.first().frame();
    long micros = poses.first().micros();
    SensorPose pose = poses.at(scan, 0.5);
    ends.take(scan, poses, band, map.up());
    forget(micros);
    List<ObjectDescription> moving = new ArrayList<>();
    int from = -1;
    int last = -1;
    for (int i = 0; i < ends.count(); i++) {
      if (ends.isEcho(i)) {
        if (last >= 0 && (i - last > BEAMS_PAST + 1 || ends.apartM(last, i) > GAP_M)) {
          thing(from, last, pose, micros)
              .ifPresent(spot -> moving.add(named(spot, scan, map, micros)));
          from = -1;
        }
        from = from < 0 ? i : from;
        last = i;
      }
    }
    if (last >= 0) {
      thing(from, last, pose, micros).ifPresent(spot -> moving.add(named(spot, scan, map, micros)));
    }
    if (earlier.isEmpty() || micros - earlier.getLast().micros() >= KEEP_EVERY_MICROS) {
      earlier.addLast(new Panorama(ends, pose, micros));
    }
    return moving;
  }

  private void forget(long micros) {
    while (!earlier.isEmpty() && micros - earlier.getFirst().micros() > LOOK_BACK_MICROS) {
      earlier.removeFirst();
    }
    spots.removeIf(spot -> micros - spot.seenMicros > LOST_MICROS);
  }

  /** A detected object with radius, position sigma and height. */
  private record Thing(Spot spot, double radius, double sigma, double z) {}

  private Optional<Thing> thing(int from, int to, SensorPose pose, long micros) {
    double width = ends.apartM(from, to);
    int echoes = 0;
    int fresh = 0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    for (int i = from; i <= to && width <= LARGEST_M; i++) {
      if (ends.isEcho(i)) {
        echoes++;
        x += ends.x(i);
        y += ends.y(i);
        z += ends.z(i);
        fresh += isFresh(i) ? 1 : 0;
      }
    }
    if (echoes < FEWEST) {
      return Optional.empty();
    }
    double dx = x / echoes - pose.place().x();
    double dy = y / echoes - pose.place().y();
    double further = 1.0 + ROUND * width / Math.max(0.1, Math.hypot(dx, dy));
    double middleX = pose.place().x() + dx * further;
    double middleY = pose.place().y() + dy * further;
    boolean moves = fresh >= FEWEST && fresh >= NEW_SHARE * echoes;
    Optional<Spot> known = spot(middleX, middleY, micros);
    if (known.isEmpty() && !moves) {
      return Optional.empty();
    }
    Spot spot = known.orElseGet(this::begin);
    spot.x = middleX;
    spot.y = middleY;
    spot.seenMicros = micros;
    spot.movedMicros = moves ? micros : spot.movedMicros;
    if (micros - spot.movedMicros > REMEMBERED_MICROS) {
      spots.remove(spot);
      return Optional.empty();
    }
    double sigma = isHidden(from, to) ? HIDDEN_SIGMA_M : SIGMA_M;
    return Optional.of(
        new Thing(spot, Math.max(SMALLEST_RADIUS_M, 0.5 * width), sigma, z / echoes));
  }

  private Spot begin() {
    Spot spot = new Spot(++found);
    spots.add(spot);
    return spot;
  }

  /** Nearest known object to a position that was not yet seen in this scan. */
  private Optional<Spot> spot(double x, double y, long micros) {
    Spot nearest = null;
    double least = STEP_M;
    for (Spot spot : spots) {
      double away = Math.hypot(spot.x - x, spot.y - y);
      if (away < least && spot.seenMicros != micros) {
        least = away;
        nearest = spot;
      }
    }
    return Optional.ofNullable(nearest);
  }

  private boolean isFresh(int beam) {
    double margin = MARGIN_M + MARGIN_PER_M * ends.freeM(beam);
    int witnesses = 0;
    Iterator<Panorama> newestFirst = earlier.descendingIterator();
    while (newestFirst.hasNext() && witnesses < WITNESSES) {
      boolean free = newestFirst.next().isFree(ends.x(beam), ends.y(beam), ends.z(beam), margin);
      witnesses += free ? 1 : 0;
    }
    return witnesses == WITNESSES;
  }

  /** Whether a closer echo borders the object, which then may be partly occluded. */
  private boolean isHidden(int from, int to) {
    return isNearer(from - 1, from) || isNearer(to + 1, to);
  }

  private boolean isNearer(int beside, int beam) {
    return beside >= 0
        && beside < ends.count()
        && ends.isEcho(beside)
        && ends.freeM(beside) < ends.freeM(beam);
  }

  private static ObjectDescription named(Thing thing, RangeScan scan, MapFrame map, long micros) {
    Point at = map.point(Point.of(thing.spot.x, thing.spot.y, thing.z));
    Circle circle = new Circle().radius(thing.radius);
    circle
        .x(at.x())
        .y(at.y())
        .z(at.z())
        .uid(scan.sensorName() + " moving " + thing.spot.number)
        .referenceFrame(map.frame())
        .sensorName(scan.sensorName());
    circle.motion().sigma(Point.of(thing.sigma, thing.sigma, thing.sigma));
    circle.timestamp(micros);
    return circle;
  }
}
