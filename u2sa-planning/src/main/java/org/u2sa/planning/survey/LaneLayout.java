package org.u2sa.planning.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Lays parallel lanes over cells: strips as wide as an image shows, split where cells are missing
 * (boustrophedon decomposition, Choset and Pignon, Coverage Path Planning: The Boustrophedon
 * Cellular Decomposition, FSR 1997; here by cells, so that concave areas and gaps are treated
 * alike). The direction with the least time of flight in the wind is chosen.
 */
final class LaneLayout {
  private static final int DIRECTIONS = 18;
  private static final double CRAWLS = 0.2; // minimum ground speed, as a share of the airspeed

  /**
   * Cells to be seen, on the planning plane.
   *
   * @param numbers of the cells
   * @param norths of their centres [m]
   * @param easts of their centres [m]
   * @param sideM side of a cell [m]
   */
  record Cells(int[] numbers, double[] norths, double[] easts, double sideM) {}

  /**
   * Flight.
   *
   * @param swathM width on the ground that a lane covers, in calm air [m]
   * @param radiusM radius of turns [m]; 0 if it turns in place
   * @param speedMps airspeed
   * @param windNorthMps northward velocity of the wind
   * @param windEastMps eastward velocity of the wind
   */
  record Flight(
      double swathM, double radiusM, double speedMps, double windNorthMps, double windEastMps) {
    /** Wind across a direction over airspeed: sine of the angle between heading and course. */
    double crab(double courseRad) {
      double across = windEastMps * Math.cos(courseRad) - windNorthMps * Math.sin(courseRad);
      return Math.max(-0.9, Math.min(0.9, across / speedMps));
    }

    private double groundMps(double courseRad) {
      double along = windNorthMps * Math.cos(courseRad) + windEastMps * Math.sin(courseRad);
      double crab = crab(courseRad);
      return Math.max(CRAWLS * speedMps, speedMps * Math.sqrt(1.0 - crab * crab) + along);
    }

    /** Mean time per metre of lanes flown in both directions [s]. */
    private double secondsPerMetre(double courseRad) {
      return 0.5 / groundMps(courseRad) + 0.5 / groundMps(courseRad + Math.PI);
    }
  }

  private LaneLayout() {}

  /** The lanes that take the least time. */
  static List<Lane> best(Cells cells, Flight flight) {
    List<Lane> best = List.of();
    double leastS = Double.POSITIVE_INFINITY;
    for (int i = 0; i < DIRECTIONS; i++) {
      double course = i * Math.PI / DIRECTIONS;
      List<Lane> lanes = along(cells, flight, course);
      double metres = lanes.stream().mapToDouble(Lane::lengthM).sum();
      // the next lane is at least a swath away
      double turnM = Math.max((Math.PI + 1.0) * flight.radiusM(), flight.swathM());
      double turns = turnM * lanes.size() / flight.speedMps();
      double seconds = metres * flight.secondsPerMetre(course) + turns;
      if (seconds < leastS) {
        leastS = seconds;
        best = lanes;
      }
    }
    return best;
  }

  /** The lanes in one direction. */
  static List<Lane> along(Cells cells, Flight flight, double courseRad) {
    int count = cells.numbers().length;
    double cos = Math.cos(courseRad);
    double sin = Math.sin(courseRad);
    double[] along = new double[count];
    double[] across = new double[count];
    Integer[] order = new Integer[count];
    for (int i = 0; i < count; i++) {
      along[i] = cells.norths()[i] * cos + cells.easts()[i] * sin;
      across[i] = cells.easts()[i] * cos - cells.norths()[i] * sin;
      order[i] = i;
    }
    Arrays.sort(order, Comparator.comparingDouble(i -> across[i]));
    double half = 0.5 * cells.sideM() * (Math.abs(cos) + Math.abs(sin));
    double crab = flight.crab(courseRad);
    // a turned image shows a narrower strip
    double swath = Math.max(2.0 * half, flight.swathM() * Math.sqrt(1.0 - crab * crab));
    // cells that touch are one lane, however tight the turns
    double join = Math.max(3.0 * flight.radiusM(), 2.0 * half + 1e-9);
    List<Lane> lanes = new ArrayList<>();
    for (int first = 0; first < count; ) {
      int next = first;
      double low = across[order[first]] - half;
      while (next < count && across[order[next]] + half <= low + swath + 1e-9) {
        next++;
      }
      double middle = 0.5 * (low + across[order[next - 1]] + half);
      Integer[] strip = Arrays.copyOfRange(order, first, next);
      Arrays.sort(strip, Comparator.comparingDouble(i -> along[i]));
      split(strip, along, middle, half, join, cells, courseRad, lanes);
      first = next;
    }
    return lanes;
  }

  private static void split(
      Integer[] strip,
      double[] along,
      double middle,
      double half,
      double joinM,
      Cells cells,
      double courseRad,
      List<Lane> lanes) {
    int first = 0;
    for (int i = 1; i <= strip.length; i++) {
      if (i == strip.length || along[strip[i]] - along[strip[i - 1]] > joinM) {
        double start = along[strip[first]] - half;
        double end = along[strip[i - 1]] + half;
        int[] numbers = new int[i - first];
        for (int k = first; k < i; k++) {
          numbers[k - first] = cells.numbers()[strip[k]];
        }
        lanes.add(
            new Lane(
                start * Math.cos(courseRad) - middle * Math.sin(courseRad),
                start * Math.sin(courseRad) + middle * Math.cos(courseRad),
                courseRad,
                end - start,
                numbers));
        first = i;
      }
    }
  }
}
