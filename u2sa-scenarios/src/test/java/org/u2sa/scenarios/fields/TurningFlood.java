package org.u2sa.scenarios.fields;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Whether something that flies straight or on circles of one radius gets through a field: a flood
 * over cells of place and heading, known nothing of the planners'.
 */
final class TurningFlood {
  private static final int HEADINGS = 36;
  private static final double BEYOND_M = 300.0;

  private final RandomField field;
  private final double cellM;
  private final int size;
  private final boolean[] free;

  TurningFlood(RandomField field, double clearanceM, double cellM) {
    this.field = field;
    this.cellM = cellM;
    size = (int) Math.ceil((field.kind.sideM() + 2.0 * BEYOND_M) / cellM);
    free = new boolean[size * size];
    for (int i = 0; i < free.length; i++) {
      free[i] =
          field.distanceM((i % size + 0.5) * cellM - BEYOND_M, (i / size + 0.5) * cellM - BEYOND_M)
              >= clearanceM;
    }
  }

  boolean reaches(double radiusM, double toleranceM) {
    boolean[] seen = new boolean[free.length * HEADINGS];
    Deque<double[]> waiting = new ArrayDeque<>();
    waiting.add(new double[] {field.startEast, field.startNorth, field.startHeading});
    double turn = 2.0 * Math.PI / HEADINGS;
    double chord = 2.0 * radiusM * Math.sin(0.5 * turn);
    while (!waiting.isEmpty()) {
      double[] at = waiting.poll();
      if (Math.hypot(at[0] - field.goalEast, at[1] - field.goalNorth) <= toleranceM) {
        return true;
      }
      for (int side = -1; side <= 1; side++) {
        double along = at[2] + 0.5 * side * turn;
        double east = at[0] + chord * Math.sin(along);
        double north = at[1] + chord * Math.cos(along);
        double heading = at[2] + side * turn;
        int column = (int) Math.floor((east + BEYOND_M) / cellM);
        int row = (int) Math.floor((north + BEYOND_M) / cellM);
        if (column < 0 || row < 0 || column >= size || row >= size || !free[row * size + column]) {
          continue;
        }
        int bin = Math.floorMod(Math.round(heading / turn), HEADINGS);
        int state = (row * size + column) * HEADINGS + bin;
        if (!seen[state]) {
          seen[state] = true;
          waiting.add(new double[] {east, north, heading});
        }
      }
    }
    return false;
  }
}
