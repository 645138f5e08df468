package org.u2sa.scenarios.roboboat.gate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.curve.Dubins;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

/**
 * Plans the path onto a gate's axis for a boat that needs steerage way: arcs and straights clear of
 * every object, ending several boat lengths in front of the gate, in its direction.
 *
 * @param path path to the start of the straight run to the gate
 * @param gate the gate as known when planning
 * @param runM length of the straight run [m]
 */
public record GateApproach(SailingPath path, Gate gate, double runM) {
  private static final double[] LEADS_M = {0.0, 4.0, 8.0}; // straight on before the first turn
  private static final double[] RADII_M = {4.0, 3.0, 2.2};
  private static final double[] RUNS_M = {10.0, 8.0, 6.0, 14.0, 4.5};
  private static final double GOOD_RUN_M = 10.0;
  private static final double SHORT_COST = 2.0; // per metre of a shorter run
  private static final double TIGHT_COST = 4.0; // per metre of a smaller radius
  private static final double NEAR_COST = 10.0; // per metre closer to an object than this:
  private static final double WELL_CLEAR_M = 2.5;
  private static final double CLEAR_M = 0.95; // clearance of arcs: half the beam and 0.6 m
  private static final double RUN_CLEAR_M = 0.7; // clearance of the run, also through a gate
  private static final double LEAVING_M = 1.5; // length within which the boat may be leaving a gate
  private static final double LEAVING_CLEAR_M = 0.45;
  private static final double FAR_M = 10.0; // waiting distance while no path is clear
  private static final double[] FAR_ASIDE_M = {0.0, 3.0, -3.0, 6.0, -6.0};
  private static final double ROOM_M = 2.5; // between the waiting position and all objects
  private static final double BEFORE_M = 1.5; // end of the part of the run that is checked

  /** The best path from a pose; empty if none is clear. */
  public static Optional<GateApproach> plan(Pose from, Gate gate, List<PlanarShape> objects) {
    Point way = gate.way();
    double heading = Math.atan2(way.y(), way.x());
    GateApproach best = null;
    double least = Double.POSITIVE_INFINITY;
    for (double run : RUNS_M) {
      Point start = gate.beyond(-run);
      Pose onAxis = new Pose(start.x(), start.y(), heading);
      Curve straight = new Curve(List.of(new Curve.Piece(run - BEFORE_M, 0.0)));
      if (clearM(straight.sampled(onAxis, SailingPath.SPACING_M), objects) < RUN_CLEAR_M) {
        continue;
      }
      for (Curve curve : curves(from, onAxis)) {
        double cost = curve.lengthM() + SHORT_COST * Math.max(0.0, GOOD_RUN_M - run);
        for (Curve.Piece piece : curve.pieces()) {
          double radius = piece.curvature() == 0.0 ? RADII_M[0] : 1.0 / Math.abs(piece.curvature());
          cost += TIGHT_COST * (RADII_M[0] - radius);
        }
        if (cost >= least) {
          continue;
        }
        List<Curve.Sample> samples = curve.sampled(from, SailingPath.SPACING_M);
        double clear = clearM(samples, objects);
        cost += NEAR_COST * Math.max(0.0, WELL_CLEAR_M - clear);
        if (clear > CLEAR_M && cost < least) {
          best = new GateApproach(path(samples, from), gate, run);
          least = cost;
        }
      }
    }
    return Optional.ofNullable(best);
  }

  /** A point in front of the gate from which a path may be found, on its axis if there is room. */
  public static Point before(Gate gate, List<PlanarShape> objects) {
    Point onAxis = gate.beyond(-FAR_M);
    Point way = gate.way();
    for (double aside : FAR_ASIDE_M) {
      Point place = onAxis.plus(Point.of(-aside * way.y(), aside * way.x(), 0.0));
      if (objects.stream().allMatch(each -> each.distanceM(place.x(), place.y()) > ROOM_M)) {
        return place;
      }
    }
    return onAxis;
  }

  /** Shift of the start of the run due to a newer estimate of the gate [m]. */
  public double movedM(Gate newer) {
    return newer.beyond(-runM).minus(gate.beyond(-runM)).distance();
  }

  private static List<Curve> curves(Pose from, Pose to) {
    List<Curve> curves = new ArrayList<>();
    for (double lead : LEADS_M) {
      Pose turning = from.along(lead, 0.0);
      for (double radius : RADII_M) {
        for (Curve curve : Dubins.all(turning, to, radius)) {
          List<Curve.Piece> pieces = new ArrayList<>();
          if (lead > 0.0) {
            pieces.add(new Curve.Piece(lead, 0.0));
          }
          pieces.addAll(curve.pieces());
          curves.add(new Curve(pieces));
        }
      }
    }
    return curves;
  }

  /** Distance from the nearest object [m]; less is allowed where the boat leaves a gate. */
  private static double clearM(List<Curve.Sample> samples, List<PlanarShape> objects) {
    int leaving = (int) (LEAVING_M / SailingPath.SPACING_M);
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < samples.size(); i++) {
      Pose pose = samples.get(i).pose();
      for (PlanarShape object : objects) {
        double away = object.distanceM(pose.northM(), pose.eastM());
        if (i >= leaving || away < LEAVING_CLEAR_M) {
          least = Math.min(least, away);
        }
      }
    }
    return least;
  }

  private static SailingPath path(List<Curve.Sample> samples, Pose from) {
    List<Pose> poses = new ArrayList<>(List.of(from));
    samples.forEach(sample -> poses.add(sample.pose()));
    return new SailingPath(poses);
  }
}
