package org.u2sa.scenarios.fields;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;

/**
 * A walled square with obstacles, dead ends and traffic at random: east and north [m] from its
 * south-western corner. Immutable, but for where the traffic is.
 */
final class RandomField {
  /**
   * How fields are.
   *
   * @param sideM edge of the square [m]
   * @param leastM least radius of an obstacle [m]
   * @param mostM greatest radius of an obstacle [m]
   * @param density greatest share of the ground that is covered
   * @param freeM kept free around start and goal [m]
   * @param traffic most that move
   * @param trafficM radius of what moves [m]
   * @param trafficMps its greatest speed [m/s]
   * @param traps greatest number of dead ends
   * @param walls whether the square is walled
   */
  record Kind(
      double sideM,
      double leastM,
      double mostM,
      double density,
      double freeM,
      int traffic,
      double trafficM,
      double trafficMps,
      int traps,
      boolean walls) {}

  /** Something that goes to and fro between two places, and stands for a while before it turns. */
  static final class Traffic {
    private static final double STANDS_S = 2.0;

    final double radiusM;
    private final double fromEast;
    private final double fromNorth;
    private final double toEast;
    private final double toNorth;
    private final double speedMps;
    private final double lengthM;
    private final double startM;

    /**
     * @param ends from east, north to east, north [m]
     * @param startM where on its round it is at first [m]
     */
    Traffic(double[] ends, double radiusM, double speedMps, double startM) {
      fromEast = ends[0];
      fromNorth = ends[1];
      toEast = ends[2];
      toNorth = ends[3];
      this.radiusM = radiusM;
      this.speedMps = speedMps;
      this.startM = startM;
      lengthM = Math.hypot(toEast - fromEast, toNorth - fromNorth);
    }

    private double round(double seconds) {
      double stands = STANDS_S * speedMps;
      return (startM + speedMps * seconds) % (2.0 * (lengthM + stands));
    }

    private double gone(double seconds) {
      double stands = STANDS_S * speedMps;
      double round = round(seconds);
      if (round <= lengthM + stands) {
        return Math.min(round, lengthM);
      }
      return Math.min(round - stands, 2.0 * lengthM);
    }

    private boolean stands(double seconds) {
      double round = round(seconds);
      double stands = STANDS_S * speedMps;
      return (round >= lengthM && round <= lengthM + stands) || round >= 2.0 * lengthM + stands;
    }

    private double share(double seconds) {
      double gone = gone(seconds);
      return (gone <= lengthM ? gone : 2.0 * lengthM - gone) / lengthM;
    }

    double eastM(double seconds) {
      return fromEast + share(seconds) * (toEast - fromEast);
    }

    double northM(double seconds) {
      return fromNorth + share(seconds) * (toNorth - fromNorth);
    }

    double eastMps(double seconds) {
      double sign = stands(seconds) ? 0.0 : gone(seconds) <= lengthM ? 1.0 : -1.0;
      return sign * speedMps * (toEast - fromEast) / lengthM;
    }

    double northMps(double seconds) {
      double sign = stands(seconds) ? 0.0 : gone(seconds) <= lengthM ? 1.0 : -1.0;
      return sign * speedMps * (toNorth - fromNorth) / lengthM;
    }
  }

  final Kind kind;
  final long seed;
  final List<ObjectDescription> obstacles = new ArrayList<>();
  private final List<double[]> outlines = new ArrayList<>(); // east, north, radius around each
  final List<Traffic> traffic = new ArrayList<>();
  final double startEast;
  final double startNorth;
  final double startHeading;
  final double goalEast;
  final double goalNorth;

  RandomField(Kind kind, long seed) {
    this.kind = kind;
    this.seed = seed;
    Random random = new Random(seed);
    double edge = 1.5 * kind.freeM;
    startEast = edge + random.nextDouble() * 0.15 * kind.sideM;
    startNorth = edge + random.nextDouble() * (kind.sideM - 2.0 * edge);
    goalEast = kind.sideM - edge - random.nextDouble() * 0.15 * kind.sideM;
    goalNorth = edge + random.nextDouble() * (kind.sideM - 2.0 * edge);
    startHeading = Math.PI / 2.0 + (random.nextDouble() - 0.5) * (kind.walls ? 2.0 * Math.PI : 1.0);
    if (kind.walls) {
      double s = kind.sideM;
      box(0.5 * s, -0.1, s + 0.4, 0.2, 0.0);
      box(0.5 * s, s + 0.1, s + 0.4, 0.2, 0.0);
      box(-0.1, 0.5 * s, 0.2, s + 0.4, 0.0);
      box(s + 0.1, 0.5 * s, 0.2, s + 0.4, 0.0);
    }
    double wanted = kind.density * (0.2 + 0.8 * random.nextDouble()) * kind.sideM * kind.sideM;
    double covered = 0.0;
    int traps = kind.traps == 0 ? 0 : random.nextInt(kind.traps + 1);
    for (int k = 0; k < traps; k++) {
      trap(random);
    }
    for (int tries = 0; covered < wanted && tries < 10_000; tries++) {
      double radius =
          kind.leastM + (kind.mostM - kind.leastM) * random.nextDouble() * random.nextDouble();
      double east = random.nextDouble() * kind.sideM;
      double north = random.nextDouble() * kind.sideM;
      boolean round = random.nextInt(3) > 0;
      double angle = random.nextDouble() * Math.PI;
      if (isKeptFree(east, north, 1.5 * radius)) {
        continue;
      }
      if (round || !kind.walls) {
        cylinder(east, north, radius);
        covered += Math.PI * radius * radius;
      } else {
        box(east, north, 2.4 * radius, 1.2 * radius, angle);
        covered += 2.88 * radius * radius;
      }
    }
    int moving = kind.traffic == 0 ? 0 : random.nextInt(kind.traffic + 1);
    for (int tries = 0; traffic.size() < moving && tries < 1000; tries++) {
      addTraffic(random);
    }
  }

  private boolean isKeptFree(double east, double north, double radius) {
    return Math.hypot(east - startEast, north - startNorth) < radius + kind.freeM
        || Math.hypot(east - goalEast, north - goalNorth) < radius + kind.freeM;
  }

  private void cylinder(double east, double north, double radius) {
    outlines.add(new double[] {east, north, radius});
    obstacles.add(
        new Cylinder()
            .radius(radius)
            .height(10.0)
            .uid("O" + obstacles.size())
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(east)
            .y(north));
  }

  private void box(double east, double north, double length, double width, double angle) {
    outlines.add(new double[] {east, north, 0.5 * Math.hypot(length, width)});
    obstacles.add(
        new Box()
            .length(length)
            .width(width)
            .height(10.0)
            .psi(angle)
            .uid("O" + obstacles.size())
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(east)
            .y(north));
  }

  /** Three walls, open towards the start. */
  private void trap(Random random) {
    double size = kind.sideM * (0.12 + 0.15 * random.nextDouble());
    double along = 0.35 + 0.4 * random.nextDouble();
    double east = startEast + along * (goalEast - startEast);
    double north = startNorth + along * (goalNorth - startNorth);
    if (isKeptFree(east, north, 1.2 * size)) {
      return;
    }
    double angle =
        Math.atan2(goalNorth - startNorth, goalEast - startEast)
            + 0.5 * (random.nextDouble() - 0.5);
    double thick = 0.02 * kind.sideM / 3.0;
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    double half = 0.5 * size;
    box(east + half * cos, north + half * sin, thick, size, angle);
    box(east - half * sin, north + half * cos, size, thick, angle);
    box(east + half * sin, north - half * cos, size, thick, angle);
  }

  private void addTraffic(Random random) {
    double[] ends = new double[4];
    for (int i = 0; i < 4; i++) {
      ends[i] = kind.trafficM + random.nextDouble() * (kind.sideM - 2.0 * kind.trafficM);
    }
    double length = Math.hypot(ends[2] - ends[0], ends[3] - ends[1]);
    if (length < 4.0 * kind.trafficM) {
      return;
    }
    double keeps = kind.trafficM + 1.5 * kind.freeM;
    for (double share = 0.0; share <= 1.0; share += 0.02) {
      double east = ends[0] + share * (ends[2] - ends[0]);
      double north = ends[1] + share * (ends[3] - ends[1]);
      if (kind.walls && distanceM(east, north) < kind.trafficM
          || Math.hypot(east - startEast, north - startNorth) < keeps
          || Math.hypot(east - goalEast, north - goalNorth) < keeps) {
        return;
      }
    }
    double speed = kind.trafficMps * (0.4 + 0.6 * random.nextDouble());
    traffic.add(new Traffic(ends, kind.trafficM, speed, random.nextDouble() * length));
  }

  /** Distance of a place from the nearest obstacle [m]. */
  double distanceM(double east, double north) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < obstacles.size(); i++) {
      double[] about = outlines.get(i);
      double de = east - about[0];
      double dn = north - about[1];
      if (Math.sqrt(de * de + dn * dn) - about[2] < least) {
        least = Math.min(least, obstacles.get(i).distanceTo(Point.of(east, north, 0.0)));
      }
    }
    return least;
  }

  /**
   * Whether a disc gets from the start to the goal between the obstacles: a flood over cells, known
   * nothing of the planners'.
   */
  boolean isSolvable(double radiusM, double cellM) {
    int size = (int) Math.ceil(kind.sideM / cellM);
    boolean[] free = new boolean[size * size];
    for (int i = 0; i < free.length; i++) {
      free[i] = distanceM((i % size + 0.5) * cellM, (i / size + 0.5) * cellM) >= radiusM;
    }
    int start = (int) (startNorth / cellM) * size + (int) (startEast / cellM);
    int goal = (int) (goalNorth / cellM) * size + (int) (goalEast / cellM);
    int[] queue = new int[free.length];
    int filled = 0;
    queue[filled++] = start;
    free[start] = false;
    for (int k = 0; k < filled; k++) {
      int cell = queue[k];
      if (cell == goal) {
        return true;
      }
      int[] near = {cell - 1, cell + 1, cell - size, cell + size};
      for (int i = 0; i < 4; i++) {
        boolean wraps = i < 2 && near[i] / size != cell / size;
        if (near[i] >= 0 && near[i] < free.length && !wraps && free[near[i]]) {
          free[near[i]] = false;
          queue[filled++] = near[i];
        }
      }
    }
    return false;
  }
}
