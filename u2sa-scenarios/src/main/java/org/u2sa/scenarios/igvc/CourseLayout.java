package org.u2sa.scenarios.igvc;

import java.util.Random;

/**
 * Layout of the lanes of a random course: four rows across the field, joined by half circles; one
 * of the inner rows is no-man's land without lines.
 *
 * @param line centre line of the whole course
 * @param lanesEnd last point of the first lane
 * @param lanesBegin first point of the second
 */
record CourseLayout(Centreline line, int lanesEnd, int lanesBegin) {
  static final double LENGTH_M = 36.576; // 120 ft
  static final double WIDTH_M = 30.48; // 100 ft

  private static final int ROWS = 4;
  private static final double MIN_WIDTH_M = 3.2; // the rules require 10 ft
  private static final double MAX_WIDTH_M = 5.2; // the rules allow 20 ft
  private static final double BETWEEN_LANES_M = 0.7;
  private static final double INNER_RADIUS_M = 1.6; // the rules require 5 ft
  private static final double STRAIGHT_M = 15.0; // at the start: 44 ft are timed

  /**
   * Creates a random layout.
   *
   * @param calm factor on the lanes' sway, 0…1
   */
  static CourseLayout random(Random random, double calm) {
    double pitch = 7.2 + 1.3 * random.nextDouble();
    double turn = 0.5 * pitch;
    double mostInTurn = Math.min(MAX_WIDTH_M, pitch - 2.0 * INNER_RADIUS_M);
    double left = turn + 0.5 * mostInTurn + 0.3;
    double right = LENGTH_M - left;
    int open = 1 + random.nextInt(2);
    Centreline line = new Centreline();
    int lanesEnd = 0;
    int lanesBegin = 0;
    Width width = new Width(random);
    for (int row = 0; row < ROWS; row++) {
      int before = line.count();
      row(line, row, left, right, pitch, mostInTurn, width, calm, random);
      if (row == open) {
        lanesEnd = Math.min(before + 10, line.count() - 1);
        lanesBegin = line.count() - 11;
      }
      if (row < ROWS - 1) {
        halfCircle(line, row, left, right, pitch, mostInTurn, width);
      }
    }
    return new CourseLayout(line, lanesEnd, lanesBegin);
  }

  private static void row(
      Centreline line,
      int row,
      double left,
      double right,
      double pitch,
      double mostInTurn,
      Width width,
      double calm,
      Random random) {
    double length = right - left;
    double waves = 1.0 + random.nextDouble();
    double room = 0.5 * (pitch - mostInTurn - BETWEEN_LANES_M);
    double sway = calm * Math.max(0.0, Math.min(room, 1.1)) * (0.3 + 0.7 * random.nextDouble());
    double sign = random.nextBoolean() ? 1.0 : -1.0;
    boolean forth = row % 2 == 0;
    double y0 = 0.5 * (WIDTH_M - (ROWS - 1) * pitch) + row * pitch;
    int steps = (int) Math.round(length / Centreline.STEP_M);
    for (int i = 0; i <= steps; i++) {
      double gone = length * i / steps;
      double begin = row == 0 ? STRAIGHT_M : 0.0;
      double share = Math.max(0.0, (gone - begin) / (length - begin));
      double fade = 16.0 * share * share * (1.0 - share) * (1.0 - share); // flat at both ends
      double phase = 2.0 * Math.PI * waves * share;
      double swayed = sign * sway * fade * StrictMath.sin(phase);
      double slope =
          sign
              * sway
              / (length - begin)
              * (fade * 2.0 * Math.PI * waves * StrictMath.cos(phase)
                  + 32.0 * share * (1.0 - share) * (1.0 - 2.0 * share) * StrictMath.sin(phase));
      double x = forth ? left + gone : right - gone;
      double heading = forth ? StrictMath.atan(slope) : Math.PI - StrictMath.atan(slope);
      line.add(x, y0 + swayed, heading, width.next(line.lengthM(), mostInTurn));
    }
  }

  private static void halfCircle(
      Centreline line,
      int row,
      double left,
      double right,
      double pitch,
      double mostInTurn,
      Width width) {
    double radius = 0.5 * pitch;
    boolean forth = row % 2 == 0;
    double x = forth ? right : left;
    double y = 0.5 * (WIDTH_M - (ROWS - 1) * pitch) + row * pitch + radius;
    int steps = (int) Math.round(Math.PI * radius / Centreline.STEP_M);
    for (int i = 1; i < steps; i++) {
      double turned = Math.PI * i / steps;
      double side = forth ? 1.0 : -1.0;
      line.add(
          x + side * radius * StrictMath.sin(turned),
          y - radius * StrictMath.cos(turned),
          forth ? turned : Math.PI - turned,
          width.next(line.lengthM(), mostInTurn));
    }
  }

  /** Lane width, which varies slowly along the lane. */
  private static final class Width {
    private final double waveM;
    private final double phase;

    Width(Random random) {
      waveM = 25.0 + 20.0 * random.nextDouble();
      phase = 2.0 * Math.PI * random.nextDouble();
    }

    double next(double alongM, double most) {
      double share = 0.5 + 0.5 * StrictMath.sin(2.0 * Math.PI * alongM / waveM + phase);
      return MIN_WIDTH_M + share * (Math.min(MAX_WIDTH_M, most) - MIN_WIDTH_M);
    }
  }
}
