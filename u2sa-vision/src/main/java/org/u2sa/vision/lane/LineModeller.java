package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Line;
import org.u2sa.world.modeller.HiddenGround;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Maps painted lines (thesis 4.1.1.2): assembles them from partial camera detections and closes the
 * gaps of dashed and worn paint, so that the planner sees complete lanes. Publishes PolyLines whose
 * confidence indicates how they are known ({@link LinePieces}).
 */
final class LineModeller implements Modeller {
  private static final double FORGET = 3.0; // in LINE REACH: farther lines are dropped
  private static final long UNSURE_MICROS = 3 * Clock.MICROS_PER_SECOND;

  private final Settings<LineModelVariables> settings;
  private final LineSamples samples = new LineSamples();
  private final HiddenGround hidden = new HiddenGround();
  private final LookedGround looked = new LookedGround();
  private final DrivenWay driven = new DrivenWay();
  private final DrivenLane lane = new DrivenLane();
  private final Set<String> sensors = new HashSet<>();
  private MapFrame frame = MapFrame.BODY;
  private long sightings;
  private int published;

  LineModeller(Configurator configuration) {
    settings = configuration.settings(LineModelVariables.class);
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    LineModelVariables tuning = settings.get();
    Set<String> types = tuning.types();
    if (sighting.vehicle().isEmpty()) {
      looked.clear();
      driven.clear();
      lane.clear();
      samples.clear(); // latest image only: motion since is unknown
    }
    double turning = sighting.vehicle().map(state -> state.psiDot().orElse(0.0)).orElse(0.0);
    if (Math.abs(turning) > tuning.steadyTurn()) {
      return;
    }
    samples.begin(sighting.micros(), tuning.lineWander() * tuning.lineWander());
    Point at = sighting.frame().vehicle(sighting.vehicle());
    driven.at(at);
    lane.at(at, sighting.micros());
    samples.from(at.x(), at.y());
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
        samples.enter(from, to, across, gate);
      }
    }
    sightings++;
  }

  /**
   * Decreases the confidence of lines that should have been seen in the last image but were not.
   */
  private void doubt(Sighting sighting, LineModelVariables tuning) {
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
    samples.doubt(
        at.x(),
        at.y(),
        heading,
        tuning.doubtReach(),
        0.5 * Math.toRadians(tuning.doubtAngle()),
        (x, y) -> !hidden.hides(x, y, tuning.hiddenBehind()));
    samples.forget(
        at.x(),
        at.y(),
        FORGET * tuning.lineReach(),
        sighting.micros() - UNSURE_MICROS,
        tuning.lineHits());
  }

  @Override
  public void enter(MapFrame newFrame, Sighting now) {
    frame = newFrame;
    samples.clear();
    looked.clear();
    driven.clear();
    lane.clear();
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    LineModelVariables tuning = settings.get();
    Point at = frame.vehicle(now.vehicle());
    int hits = frame.frame().isBody() ? 1 : tuning.lineHits();
    LineChains chains = LineChains.of(samples.certain(at.x(), at.y(), tuning.lineReach(), hits));
    String type = tuning.types().iterator().next();
    LinePieces pieces = new LinePieces(frame, type, at, tuning.clearOfVehicle());
    LineGaps gaps =
        new LineGaps(chains.lines(), tuning.reach(), looked::isKnown, driven::passesBetween);
    for (List<Point> line : chains.lines()) {
      if (chains.isSure(line)) {
        pieces.certain(line);
      } else {
        pieces.uncertain(line, piece -> gaps.isLaneSide(piece, line));
      }
    }
    if (tuning.joinGap() > 0.0 || tuning.lineExtension() > 0.0) {
      for (LineGaps.Joint joint : gaps.joined()) {
        boolean sure = chains.isSure(joint.one()) && chains.isSure(joint.other());
        pieces.guessed(joint.points(), piece -> sure || gaps.isLaneSide(piece, joint.one()));
      }
      for (LineGaps.Extension each : gaps.extended()) {
        pieces.guessed(each.points(), piece -> gaps.isLaneSide(piece, each.line()));
      }
      for (DrivenLane.Inferred side : sides(chains, gaps, tuning)) {
        pieces.inferred(side.points(), LinePieces.DRIVEN);
        if (side.atVehicle()) {
          pieces.guessed(gaps.onward(side.points(), at), piece -> true);
        }
      }
      pieces.inferred(
          lane.wayBack(), lane.isHeldUp(now.micros()) ? LinePieces.GUESS : LinePieces.DRIVEN);
    }
    published = pieces.all().size();
    return pieces.all();
  }

  /** Sides of the driven lane; joints count as lines for this, extensions do not. */
  private List<DrivenLane.Inferred> sides(
      LineChains chains, LineGaps gaps, LineModelVariables tuning) {
    List<DrivenLane.Known> known = new ArrayList<>();
    chains.lines().forEach(line -> known.add(new DrivenLane.Known(line, chains.isSure(line))));
    gaps.joined().forEach(joint -> known.add(new DrivenLane.Known(joint.points(), false)));
    return lane.sides(known, tuning.reach());
  }

  @Override
  public String remark() {
    return sightings + " sightings, " + samples.count() + " places, " + published + " pieces";
  }
}
