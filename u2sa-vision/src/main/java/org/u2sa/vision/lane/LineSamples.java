package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;

/**
 * Painted lines as sample points, each with a direction, a Kalman filter of its lateral position,
 * and a count of sightings for and against it.
 */
final class LineSamples {
  /** Published line width, 3 in [m]. */
  static final double WIDTH_M = 0.0762;

  /** Sample spacing [m]. */
  static final double STEP_M = 0.15;

  private static final double ALONG_M = 0.6 * STEP_M; // samples closer along the line are the same
  private static final double PARALLEL = 0.82; // cosine of the angle between two parts of one line
  private static final double CELL_M = 0.5;
  private static final double MIN_SIGMA_M = 0.025; // because the vehicle's position drifts
  private static final double MAX_HITS = 15.0;
  private static final double DOUBT = 0.4; // subtracted from the hits of an unseen sample
  private static final double TOO_NEAR_M = 1.3; // closer ground is below the camera's view
  private static final double TWICE_M = 1.0; // closer lines are one line, seen twice
  private static final double VIEW_M = 0.25; // spacing of viewpoints
  private static final double REFUTED =
      0.5; // weight of a sighting, if the line was seen at another position
  private static final long ANOTHER_TIME = 2 * Clock.MICROS_PER_SECOND;

  static final class Sample {
    double x;
    double y;
    double dx; // direction of the line, either way
    double dy;
    double variance; // lateral [m²]
    double hits = 1.0;
    int views = 1; // viewpoints from which it was seen
    long seenMicros;
    private double viewX; // last viewpoint
    private double viewY;
    private long refutedMicros = Long.MIN_VALUE;
    private long cell;
  }

  private final List<Sample> all = new ArrayList<>();
  private final Map<Long, List<Sample>> cells = new HashMap<>();
  private long micros;
  private double fromX; // vehicle position
  private double fromY;
  private double wanderPerS; // drift of the vehicle's position [m²/s]

  void clear() {
    all.clear();
    cells.clear();
  }

  int count() {
    return all.size();
  }

  /**
   * Sets the time of the next sightings.
   *
   * @param wander random-walk drift of the vehicle's position [m²/s]: a line that was not seen for
   *     a while may appear shifted
   */
  void begin(long nowMicros, double wander) {
    micros = nowMicros;
    wanderPerS = wander;
  }

  /** Sets the viewpoint of the next sightings [m]. */
  void from(double vehicleX, double vehicleY) {
    fromX = vehicleX;
    fromY = vehicleY;
  }

  /** Adds a straight line segment that was seen. */
  void enter(Point from, Point to, double sigmaM, double gateM) {
    double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
    if (length < 1.0e-6) {
      return;
    }
    double dx = (to.x() - from.x()) / length;
    double dy = (to.y() - from.y()) / length;
    int steps = Math.max(1, (int) Math.round(length / STEP_M));
    for (int i = 0; i < steps; i++) {
      double share = (i + 0.5) / steps;
      enter(
          from.x() + share * (to.x() - from.x()),
          from.y() + share * (to.y() - from.y()),
          dx,
          dy,
          sigmaM,
          gateM);
    }
  }

  private void enter(double x, double y, double dx, double dy, double sigmaM, double gateM) {
    Sample nearest = null;
    double least = Double.POSITIVE_INFINITY;
    for (Sample sample : near(x, y, Math.max(TWICE_M, 2.0 * gateM) + STEP_M)) {
      double along = Math.abs((x - sample.x) * sample.dx + (y - sample.y) * sample.dy);
      double across = Math.abs((x - sample.x) * sample.dy - (y - sample.y) * sample.dx);
      boolean parallel = Math.abs(dx * sample.dx + dy * sample.dy) > PARALLEL;
      if (!parallel || along > ALONG_M) {
        continue;
      }
      double gate = gateM + Math.min(gateM, Math.sqrt(wandered(sample)));
      double cost = along / ALONG_M + across / gate;
      if (across <= gate && cost < least) {
        nearest = sample;
        least = cost;
      }
      if (across > gate && across < TWICE_M && micros - sample.seenMicros > ANOTHER_TIME) {
        sample.refutedMicros = micros;
      }
    }
    if (nearest == null) {
      add(x, y, dx, dy, sigmaM);
    } else {
      correct(nearest, x, y, dx, dy, sigmaM);
    }
  }

  /** Variance a sample has gained since it was last seen [m²]. */
  private double wandered(Sample sample) {
    return wanderPerS * Clock.seconds(Math.max(0L, micros - sample.seenMicros));
  }

  private void add(double x, double y, double dx, double dy, double sigmaM) {
    Sample sample = new Sample();
    sample.x = x;
    sample.y = y;
    sample.dx = dx;
    sample.dy = dy;
    sample.variance = sigmaM * sigmaM;
    sample.seenMicros = micros;
    sample.viewX = fromX;
    sample.viewY = fromY;
    sample.cell = cell(x, y);
    all.add(sample);
    cells.computeIfAbsent(sample.cell, key -> new ArrayList<>()).add(sample);
  }

  private void correct(Sample sample, double x, double y, double dx, double dy, double sigmaM) {
    double variance = sample.variance + wandered(sample);
    double gain = variance / (variance + sigmaM * sigmaM);
    double across = (x - sample.x) * -sample.dy + (y - sample.y) * sample.dx;
    sample.x += gain * across * -sample.dy;
    sample.y += gain * across * sample.dx;
    double sign = dx * sample.dx + dy * sample.dy < 0.0 ? -1.0 : 1.0;
    double turnedX = sample.dx + 0.5 * gain * (sign * dx - sample.dx);
    double turnedY = sample.dy + 0.5 * gain * (sign * dy - sample.dy);
    double length = Math.hypot(turnedX, turnedY);
    sample.dx = turnedX / length;
    sample.dy = turnedY / length;
    sample.variance = Math.max(MIN_SIGMA_M * MIN_SIGMA_M, (1.0 - gain) * variance);
    if (sample.seenMicros != micros) {
      sample.hits = Math.min(MAX_HITS, sample.hits + 1.0); // once per image
      sample.seenMicros = micros;
      if (Math.hypot(fromX - sample.viewX, fromY - sample.viewY) >= VIEW_M) {
        sample.views++;
        sample.viewX = fromX;
        sample.viewY = fromY;
      }
    }
    long now = cell(sample.x, sample.y);
    if (now != sample.cell) {
      cells.get(sample.cell).remove(sample);
      sample.cell = now;
      cells.computeIfAbsent(now, key -> new ArrayList<>()).add(sample);
    }
  }

  private List<Sample> near(double x, double y, double reachM) {
    List<Sample> found = new ArrayList<>();
    int span = (int) Math.ceil(reachM / CELL_M);
    int column = (int) Math.floor(x / CELL_M);
    int row = (int) Math.floor(y / CELL_M);
    for (int r = row - span; r <= row + span; r++) {
      for (int c = column - span; c <= column + span; c++) {
        found.addAll(cells.getOrDefault(CellKey.of(c, r), List.of()));
      }
    }
    return found;
  }

  private static long cell(double x, double y) {
    return CellKey.of((int) Math.floor(x / CELL_M), (int) Math.floor(y / CELL_M));
  }

  /**
   * Decreases the confidence of unoccluded samples in a sector that the last image does not show,
   * and of samples whose line was seen beside them: it is the same line unless the image shows
   * both.
   */
  void doubt(
      double x,
      double y,
      double headingRad,
      double reachM,
      double halfRad,
      LookedGround.View view) {
    for (Sample sample : near(x, y, reachM)) {
      double away = Math.hypot(sample.x - x, sample.y - y);
      double off =
          Math.IEEEremainder(Math.atan2(sample.y - y, sample.x - x) - headingRad, 2.0 * Math.PI);
      boolean looked = away > TOO_NEAR_M && away < reachM && Math.abs(off) < halfRad;
      if (looked && sample.seenMicros != micros && view.isOpen(sample.x, sample.y)) {
        sample.hits -= DOUBT;
      }
    }
    for (Sample sample : all) {
      if (sample.refutedMicros == micros && sample.seenMicros != micros) {
        sample.hits -= REFUTED;
      }
    }
  }

  /** Drops samples that are refuted, far away, or neither confirmed nor seen since a time. */
  void forget(double x, double y, double reachM, long beforeMicros, int hits) {
    List<Sample> gone = new ArrayList<>();
    for (Sample sample : all) {
      boolean unsure = sample.hits < hits && sample.seenMicros < beforeMicros;
      if (sample.hits <= 0.0 || unsure || Math.hypot(sample.x - x, sample.y - y) > reachM) {
        gone.add(sample);
        cells.get(sample.cell).remove(sample);
      }
    }
    all.removeAll(new HashSet<>(gone));
  }

  /** Samples seen often enough within a range. */
  List<Sample> certain(double x, double y, double reachM, int hits) {
    List<Sample> found = new ArrayList<>();
    for (Sample sample : all) {
      if (sample.hits >= hits && Math.hypot(sample.x - x, sample.y - y) <= reachM) {
        found.add(sample);
      }
    }
    return found;
  }
}
