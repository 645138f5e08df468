package org.u2sa.core.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PolyLine;

/**
 * Keeps painted lines (thesis 4.1.1.2): puts together what a camera sees of them piece by piece,
 * and closes the gaps of dashed and worn paint, so that a lane is a lane for the planner. Publishes
 * PolyLines; those that close a gap, or were seen from one place only, have a confidence of 0.5.
 */
final class LineModeller implements Modeller {
  private static final double GAP_CONFIDENCE = 0.5;
  private static final int POINTS_A_PIECE = 14; // short pieces are found and drawn faster

  record Tuning(
      @Variable(
              ifAbsentText = "white line",
              text = "LINES: types of objects that are painted lines, separated by commas.")
          String lineTypes,
      @Variable(
              unit = "m",
              min = 0.01,
              max = 5,
              ifAbsent = 0.35,
              text = "LINES: distance up to which a sighting beside a known line is that line.")
          double lineGate,
      @Variable(
              min = 1,
              max = 20,
              ifAbsent = 3,
              text = "LINES: sightings that make a line certain.")
          int lineHits,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 0,
              text =
                  "LINES: longest gap in a line that is closed, between two ends that face each"
                      + " other; 0: none.")
          double joinGap,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 0,
              text = "LINES: how far a line is taken to go on beyond the end that was seen.")
          double lineExtension,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 0,
              text =
                  "LINES: how far a line is taken to go on beside the other line of its lane,"
                      + " beyond the end that was seen; 0: as LINE EXTENSION.")
          double laneExtension,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 6.1,
              text = "LINES: greatest width of a lane, for LANE EXTENSION.")
          double widestLane,
      @Variable(
              unit = "m",
              min = 0,
              max = 10,
              ifAbsent = 0,
              text =
                  "LINES: how far the vehicle's place wanders against the ground in a second; in"
                      + " other times it grows with their root. Lines that were not seen for a"
                      + " while are looked for so much farther away.")
          double lineWander,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 1.5,
              text =
                  "LINES: how near to other lines such an extension comes at most: the least width"
                      + " of a lane.")
          double laneWidth,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 2.5,
              text =
                  "LINES: reach ahead within which a line that is there is seen; one that is not"
                      + " seen there is doubted.")
          double doubtReach,
      @Variable(
              unit = "deg",
              min = 0,
              max = 360,
              ifAbsent = 50,
              text = "LINES: width of the sector ahead in which lines are doubted.")
          double doubtAngle,
      @Variable(
              unit = "m",
              min = 1,
              max = 1000,
              ifAbsent = 15,
              text = "LINES: distance from the vehicle up to which lines are published.")
          double lineReach,
      @Variable(
              unit = "m",
              min = 0,
              max = 10,
              ifAbsent = 0,
              text =
                  "LINES: nothing that closes a gap comes nearer to the vehicle's reference point,"
                      + " as it would not stand there: about half its width.")
          double clearOfVehicle,
      @Variable(
              unit = "m",
              min = 0,
              max = 1000,
              ifAbsent = 0,
              text =
                  "LINES: how far behind what a scanner sees a camera does not see the ground: what"
                      + " looks like a line there is part of what stands before it.")
          double hiddenBehind,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 0,
              text =
                  "LINES: reach within which a camera sees all paint; where a line ends, and the"
                      + " ground beyond was looked at as far as JOIN GAP, it is not taken to go on;"
                      + " 0: always is.")
          double lookReach,
      @Variable(
              unit = "deg",
              min = 0,
              max = 360,
              ifAbsent = 80,
              text = "LINES: width of the sector ahead for LOOK REACH.")
          double lookAngle,
      @Variable(
              unit = "rad/s",
              min = 0,
              max = 100,
              ifAbsent = 100,
              text =
                  "LINES: pictures taken while the vehicle turns faster are not entered: rolling"
                      + " shutters bend lines.")
          double steadyTurn) {
    Set<String> types() {
      Set<String> types = new HashSet<>();
      Arrays.stream(lineTypes.split(",")).map(String::trim).forEach(types::add);
      return types;
    }
  }

  private static final double FORGET = 3.0; // of LINE REACH: farther lines are dropped
  private static final long UNSURE_MICROS = 3 * Clock.MICROS_PER_SECOND;

  private final Settings<Tuning> settings;
  private final LineBeads beads = new LineBeads();
  private final HiddenGround hidden = new HiddenGround();
  private final LookedGround looked = new LookedGround();
  private final DrivenWay driven = new DrivenWay();
  private final Set<String> sensors = new HashSet<>();
  private MapFrame frame = MapFrame.BODY;
  private long sightings;
  private int published;

  LineModeller(Configurator configuration) {
    settings = configuration.settings(Tuning.class);
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    Tuning tuning = settings.get();
    Set<String> types = tuning.types();
    if (sighting.vehicle().isEmpty()) {
      looked.clear();
      driven.clear();
      beads.clear(); // of one moment only: nothing says how the vehicle has moved since
    }
    double turning = sighting.vehicle().map(state -> state.psiDot().orElse(0.0)).orElse(0.0);
    if (Math.abs(turning) > tuning.steadyTurn()) {
      return;
    }
    beads.begin(sighting.micros(), tuning.lineWander() * tuning.lineWander());
    Point at = sighting.frame().vehicle(sighting.vehicle());
    driven.at(at);
    beads.from(at.x(), at.y());
    hidden.lookFrom(at.x(), at.y(), sighting.micros());
    boolean isPicture = false;
    for (ObjectDescription object : seen) {
      if (object instanceof Line line && types.contains(object.objectType())) {
        sighting.frame().placed(line, sighting.vehicle()).ifPresent(placed -> enter((Line) placed));
        sensors.add(object.sensorName());
      }
      isPicture |= sensors.contains(object.sensorName());
    }
    if (isPicture && sighting.vehicle().isPresent()) {
      doubt(sighting, tuning);
    }
  }

  @Override
  public void scan(RangeScan scan, ScanPoses poses) {
    if (settings.get().hiddenBehind() > 0.0) {
      hidden.scan(scan, poses.at(scan, 0.5), poses.first().frame().up(), poses.first().micros());
    }
  }

  private void enter(Line line) {
    Point sigma = line.motion().sigma().orElse(Point.of(0.1, 0.1, 0.0));
    double across = Math.sqrt(0.5 * (sigma.x() * sigma.x() + sigma.y() * sigma.y()));
    double gate = settings.get().lineGate();
    List<Point> points = line.points().stream().map(frame::metres).collect(Collectors.toList());
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      double x = 0.5 * (from.x() + to.x());
      double y = 0.5 * (from.y() + to.y());
      if (!hidden.hides(x, y, settings.get().hiddenBehind())) {
        beads.enter(from, to, across, gate);
      }
    }
    sightings++;
  }

  /** What should have been seen just now and was not. */
  private void doubt(Sighting sighting, Tuning tuning) {
    MapFrame map = sighting.frame();
    Point at = map.vehicle(sighting.vehicle());
    Point ahead = map.mapFromFrd(sighting.vehicle()).times(Point.of(1.0, 0.0, 0.0));
    double heading = Math.atan2(ahead.y(), ahead.x());
    double half = 0.5 * Math.toRadians(tuning.lookAngle());
    looked.look(
        at.x(),
        at.y(),
        heading,
        tuning.lookReach(),
        half,
        (x, y) -> !hidden.hides(x, y, tuning.hiddenBehind()));
    beads.doubt(
        at.x(),
        at.y(),
        heading,
        tuning.doubtReach(),
        0.5 * Math.toRadians(tuning.doubtAngle()),
        (x, y) -> !hidden.hides(x, y, tuning.hiddenBehind()));
    beads.forget(
        at.x(),
        at.y(),
        FORGET * tuning.lineReach(),
        sighting.micros() - UNSURE_MICROS,
        tuning.lineHits());
  }

  @Override
  public void enter(MapFrame newFrame, Sighting now) {
    frame = newFrame;
    beads.clear();
    looked.clear();
    driven.clear();
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    Tuning tuning = settings.get();
    Point at = frame.vehicle(now.vehicle());
    int hits = frame.frame().isBody() ? 1 : tuning.lineHits();
    LineChains chains =
        LineChains.of(beads.certain(at.x(), at.y(), tuning.lineReach(), hits), tuning.laneWidth());
    List<ObjectDescription> lines = new ArrayList<>();
    String type = tuning.types().iterator().next();
    for (List<Point> line : chains.lines()) {
      pieces(line, type, chains.isSure(line) ? 1.0 : GAP_CONFIDENCE, lines);
    }
    if (tuning.joinGap() > 0.0 || tuning.lineExtension() > 0.0) {
      LineChains.Reach reach =
          new LineChains.Reach(
              tuning.joinGap(),
              tuning.lineExtension(),
              Math.max(tuning.laneExtension(), tuning.lineExtension()),
              tuning.widestLane());
      for (List<Point> gap : chains.gaps(reach, looked::isKnown, driven::passesBetween)) {
        clear(gap, at, tuning.clearOfVehicle())
            .forEach(part -> pieces(part, type, GAP_CONFIDENCE, lines));
      }
    }
    published = lines.size();
    return lines;
  }

  /** The parts of a line that are so far from a place. */
  private static List<List<Point>> clear(List<Point> line, Point from, double leastM) {
    List<List<Point>> parts = new ArrayList<>();
    List<Point> part = new ArrayList<>();
    for (Point point : line) {
      if (Math.hypot(point.x() - from.x(), point.y() - from.y()) >= leastM) {
        part.add(point);
      } else if (!part.isEmpty()) {
        parts.add(part);
        part = new ArrayList<>();
      }
    }
    parts.add(part);
    parts.removeIf(each -> each.size() < 2);
    return parts;
  }

  private void pieces(
      List<Point> line, String type, double confidence, List<ObjectDescription> into) {
    for (int from = 0; from == 0 || from < line.size() - 1; from += POINTS_A_PIECE) {
      List<Point> points =
          line.subList(from, Math.min(line.size(), from + POINTS_A_PIECE + 1)).stream()
              .map(frame::point)
              .collect(Collectors.toList());
      PolyLine piece = new PolyLine();
      piece
          .points(points)
          .width(LineBeads.WIDTH_M)
          .uid("line " + (into.size() + 1))
          .objectType(type)
          .referenceFrame(frame.frame())
          .x(points.get(0).x())
          .y(points.get(0).y())
          .level(ObjectLevel.AVOID_ALWAYS)
          .confidence(confidence);
      into.add(piece);
    }
  }

  @Override
  public String remark() {
    return sightings + " sightings, " + beads.count() + " places, " + published + " pieces";
  }
}
