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
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PolyLine;

/**
 * Keeps painted lines (thesis 4.1.1.2): puts together what a camera sees of them piece by piece,
 * and closes the gaps of dashed and worn paint, so that a lane is a lane for the planner. Publishes
 * PolyLines; those that close a gap have a confidence of 0.5.
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
                  "LINES: longest gap in a line that is closed, between two ends that face each other; 0: none.")
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
              ifAbsent = 1.5,
              text =
                  "LINES: how near to other lines such an extension comes at most: the least width of a lane.")
          double laneWidth,
      @Variable(
              unit = "m",
              min = 0,
              max = 100,
              ifAbsent = 2.5,
              text =
                  "LINES: reach ahead within which a line that is there is seen; one that is not seen there is doubted.")
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
                  "LINES: nothing that closes a gap comes nearer to the vehicle's reference point, as it would not stand there: about half its width.")
          double clearOfVehicle,
      @Variable(
              unit = "rad/s",
              min = 0,
              max = 100,
              ifAbsent = 100,
              text =
                  "LINES: pictures taken while the vehicle turns faster are not entered: rolling shutters bend lines.")
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
      beads.clear(); // of one moment only: nothing says how the vehicle has moved since
    }
    double turning = sighting.vehicle().map(state -> state.psiDot().orElse(0.0)).orElse(0.0);
    if (Math.abs(turning) > tuning.steadyTurn()) {
      return;
    }
    beads.begin(sighting.micros());
    boolean looked = false;
    for (ObjectDescription object : seen) {
      if (object instanceof Line line && types.contains(object.objectType())) {
        sighting.frame().placed(line, sighting.vehicle()).ifPresent(placed -> enter((Line) placed));
        sensors.add(object.sensorName());
      }
      looked |= sensors.contains(object.sensorName());
    }
    if (looked && sighting.vehicle().isPresent()) {
      doubt(sighting, tuning);
    }
  }

  private void enter(Line line) {
    Point sigma = line.motion().sigma().orElse(Point.of(0.1, 0.1, 0.0));
    double across = Math.sqrt(0.5 * (sigma.x() * sigma.x() + sigma.y() * sigma.y()));
    double gate = settings.get().lineGate();
    List<Point> points = line.points().stream().map(frame::metres).collect(Collectors.toList());
    for (int i = 1; i < points.size(); i++) {
      beads.enter(points.get(i - 1), points.get(i), across, gate);
    }
    sightings++;
  }

  /** What should have been seen just now and was not. */
  private void doubt(Sighting sighting, Tuning tuning) {
    MapFrame map = sighting.frame();
    Point at = map.vehicle(sighting.vehicle());
    Point ahead = map.mapFromFrd(sighting.vehicle()).times(Point.of(1.0, 0.0, 0.0));
    beads.doubt(
        at.x(),
        at.y(),
        Math.atan2(ahead.y(), ahead.x()),
        tuning.doubtReach(),
        0.5 * Math.toRadians(tuning.doubtAngle()));
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
    chains.lines().forEach(line -> pieces(line, type, 1.0, lines));
    if (tuning.joinGap() > 0.0 || tuning.lineExtension() > 0.0) {
      chains.gaps(tuning.joinGap(), tuning.lineExtension()).stream()
          .filter(gap -> clearM(gap, at) >= tuning.clearOfVehicle())
          .forEach(gap -> pieces(gap, type, GAP_CONFIDENCE, lines));
    }
    published = lines.size();
    return lines;
  }

  /** Distance of a line from a place [m]. */
  private static double clearM(List<Point> line, Point from) {
    double least = Double.POSITIVE_INFINITY;
    for (Point point : line) {
      least = Math.min(least, Math.hypot(point.x() - from.x(), point.y() - from.y()));
    }
    return least;
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
