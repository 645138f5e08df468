package org.u2sa.planning.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Distances and searches, against what brute force and Bellman and Ford find. */
class SearchProperties {
  private static final int SIZE = 24;
  private static final GridFrame FRAME = new GridFrame(-3.0, 5.0, 0.5, SIZE, SIZE);
  private static final Inflation INFLATION = new Inflation(0.6, 2.0, 3.0);

  @Property(tries = 200)
  void distances_changedInPlaces_areThoseOfBruteForce(@ForAll long seed) {
    Random random = new Random(seed);
    int reach = 1 + random.nextInt(8);
    byte[] states = new byte[SIZE * SIZE];
    DistanceField field = new DistanceField(SIZE, SIZE, reach);
    for (int round = 0; round < 5; round++) {
      int top = random.nextInt(SIZE);
      int left = random.nextInt(SIZE);
      int bottom = Math.min(SIZE - 1, top + random.nextInt(6));
      int right = Math.min(SIZE - 1, left + random.nextInt(6));
      double density = 0.5 * random.nextDouble();
      for (int row = top; row <= bottom; row++) {
        for (int column = left; column <= right; column++) {
          states[row * SIZE + column] = state(random, density);
        }
      }
      field.update(states, top, left, bottom, right);
    }
    for (int i = 0; i < states.length; i++) {
      assertThat((double) field.cells(i)).isCloseTo(bruteForce(states, i, reach), within(1e-4));
    }
  }

  @Property(tries = 100)
  void cost_ofACellThatWasSeen_isTheInflationsAtItsDistance(@ForAll long seed) {
    Random random = new Random(seed);
    double reachM = 0.7 + 5.0 * random.nextDouble();
    Inflation inflation = new Inflation(0.6, reachM, 3.0);
    CostGrid grid = new CostGrid(FRAME, inflation);
    double density = 0.1 * random.nextDouble();
    byte[] states = new byte[SIZE * SIZE];
    for (int i = 0; i < states.length; i++) {
      states[i] = random.nextDouble() < density ? CostGrid.OCCUPIED : 0;
    }
    grid.update(states);
    for (int i = 0; i < states.length; i++) {
      assertThat(grid.cost(i)).isEqualTo((float) inflation.cost(grid.distanceM(i)));
    }
  }

  private static byte state(Random random, double density) {
    int full = random.nextDouble() < density ? CostGrid.OCCUPIED : 0;
    return (byte) (random.nextInt(4) == 0 ? full | CostGrid.UNKNOWN : full);
  }

  private static double bruteForce(byte[] states, int at, int reach) {
    double least = reach;
    for (int i = 0; i < states.length; i++) {
      if ((states[i] & CostGrid.OCCUPIED) != 0) {
        least = Math.min(least, Math.hypot(at / SIZE - i / SIZE, at % SIZE - i % SIZE));
      }
    }
    return least;
  }

  @Property(tries = 100)
  void update_someStatesChanged_isAsAGridThatHadThemFromTheBeginning(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid changing = new CostGrid(FRAME, INFLATION);
    byte[] states = new byte[SIZE * SIZE];
    for (int round = 0; round < 4; round++) {
      float[] before = costs(changing);
      for (int changes = random.nextInt(9); changes > 0; changes--) {
        states[random.nextInt(states.length)] = state(random, 0.3);
      }
      CostGrid.Area area = changing.update(states);

      CostGrid fresh = new CostGrid(FRAME, INFLATION);
      fresh.update(
          i -> (states[i] & CostGrid.OCCUPIED) != 0, i -> (states[i] & CostGrid.UNKNOWN) != 0);
      assertThat(costs(changing)).isEqualTo(costs(fresh));
      for (int i = 0; i < states.length; i++) {
        assertThat(changing.isOccupied(i)).isEqualTo(fresh.isOccupied(i));
        assertThat(changing.isUnknown(i)).isEqualTo(fresh.isUnknown(i));
        assertThat(changing.cost(i) == before[i] || contains(area, i)).isTrue();
      }
      assertThat(changing.update(states)).isNull();
    }
  }

  private static boolean contains(CostGrid.Area area, int cell) {
    return area != null
        && cell / SIZE >= area.firstRow()
        && cell / SIZE <= area.lastRow()
        && cell % SIZE >= area.firstColumn()
        && cell % SIZE <= area.lastColumn();
  }

  private static float[] costs(CostGrid grid) {
    float[] costs = new float[SIZE * SIZE];
    for (int i = 0; i < costs.length; i++) {
      costs[i] = grid.cost(i);
    }
    return costs;
  }

  @Property(tries = 300)
  void aStar_randomGrid_costsWhatBellmanAndFordSay(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid grid = grid(random);
    int start = free(grid, random);
    int goal = free(grid, random);

    Optional<GridPath> path = plan(new ThetaStar(false), grid, start, goal);

    double expected = bellmanFord(grid, start)[goal];
    assertThat(path.isPresent()).isEqualTo(expected < Double.POSITIVE_INFINITY);
    path.ifPresent(way -> assertThat(way.cost()).isCloseTo(expected, within(1e-4)));
    path.ifPresent(way -> assertIsFree(grid, way));
  }

  @Property(tries = 300)
  void thetaStar_randomGrid_findsAWayWhereThereIsOneAndHardlyACostlier(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid grid = grid(random);
    int start = free(grid, random);
    int goal = free(grid, random);

    Optional<GridPath> path = plan(new ThetaStar(), grid, start, goal);

    double alongCells = bellmanFord(grid, start)[goal];
    assertThat(path.isPresent()).isEqualTo(alongCells < Double.POSITIVE_INFINITY);
    path.ifPresent(
        way -> {
          assertThat(way.cost()).isLessThanOrEqualTo(1.02 * alongCells + 1e-4);
          assertIsFree(grid, way);
        });
  }

  private static void assertIsFree(CostGrid grid, GridPath way) {
    for (int i = 1; i < way.corners().size(); i++) {
      GridPath.Corner from = way.corners().get(i - 1);
      GridPath.Corner to = way.corners().get(i);
      assertThat(grid.straightCost(from.northM(), from.eastM(), to.northM(), to.eastM()))
          .isLessThan(Double.POSITIVE_INFINITY);
    }
  }

  @Property(tries = 300)
  void straightCost_goalFarOutside_isThatToTheEdgeAndOnePerMetreBeyond(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid grid = grid(random);
    int start = free(grid, random);
    double north = FRAME.centreNorthM(start);
    double east = FRAME.centreEastM(start);
    double angle = 2.0 * Math.PI * random.nextDouble();
    double outsideM = 2.0 * SIZE * FRAME.cellM();
    double[] cost = new double[2];
    for (int i = 0; i < 2; i++) {
      double away = outsideM * (1.0 + 1000.0 * i);
      cost[i] =
          grid.straightCost(
              north, east, north + away * Math.cos(angle), east + away * Math.sin(angle));
    }
    if (cost[0] < Double.POSITIVE_INFINITY && cost[1] < Double.POSITIVE_INFINITY) {
      assertThat(cost[1] - 1000.0 * outsideM).isCloseTo(cost[0], within(0.05 * cost[0]));
    } else { // a corner may be sampled by one of them only
      assertThat(Math.max(cost[0], cost[1])).isInfinite();
    }
  }

  @Property(tries = 50)
  void thetaStar_goalOutside_leavesWhereTheRestIsCheapest(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid grid = grid(random);
    int start = free(grid, random);
    double north = 40.0;
    double east = 20.0 * random.nextDouble();

    Optional<GridPath> path = new ThetaStar(false).plan(grid, start, north, east);

    double[] costs = bellmanFord(grid, start);
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < SIZE * SIZE; i++) {
      int row = i / SIZE;
      int column = i % SIZE;
      if (row == 0 || column == 0 || row == SIZE - 1 || column == SIZE - 1) {
        double rest = Math.hypot(FRAME.centreNorthM(i) - north, FRAME.centreEastM(i) - east);
        least = Math.min(least, costs[i] + rest);
      }
    }
    assertThat(path.map(GridPath::cost).orElse(Double.POSITIVE_INFINITY))
        .isCloseTo(least, within(1e-4));
  }

  @Property(tries = 200)
  void dStarLite_gridChangesWhileItMoves_costsWhatBellmanAndFordSay(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid grid = grid(random);
    int goal = free(grid, random);
    DStarLite search =
        random.nextInt(4) == 0
            ? new DStarLite(grid, 40.0, 20.0 * random.nextDouble())
            : new DStarLite(grid, FRAME.centreNorthM(goal), FRAME.centreEastM(goal));
    for (int round = 0; round < 6; round++) {
      int start = free(grid, random);
      Optional<GridPath> path = search.plan(start);

      double expected =
          search.isFor(grid, FRAME.centreNorthM(goal), FRAME.centreEastM(goal))
              ? bellmanFord(grid, start)[goal]
              : new ThetaStar(false)
                  .plan(grid, start, search.goalNorthM, search.goalEastM)
                  .map(GridPath::cost)
                  .orElse(Double.POSITIVE_INFINITY);
      assertThat(path.isPresent()).as("round %d", round).isEqualTo(expected < 1e9);
      path.ifPresent(way -> assertThat(way.cost()).isCloseTo(expected, within(1e-3)));
      path.ifPresent(way -> assertIsFree(grid, way));
      int row = random.nextInt(SIZE);
      int column = random.nextInt(SIZE);
      boolean full = random.nextBoolean();
      grid.update(
          i ->
              Math.abs(i / SIZE - row) < 3 && Math.abs(i % SIZE - column) < 3
                  ? full
                      && i != goal
                      && Math.hypot(i / SIZE - goal / SIZE, i % SIZE - goal % SIZE) > 2
                  : grid.isOccupied(i),
          grid::isUnknown);
    }
  }

  @Property(tries = 50)
  void dStarLite_goalToldAnewInItsCell_repairsWhatItFound(@ForAll long seed) {
    Random random = new Random(seed);
    CostGrid grid = grid(random);
    int goal = free(grid, random);
    double north = FRAME.centreNorthM(goal);
    double east = FRAME.centreEastM(goal);
    DStarLite search = new DStarLite(grid, north, east);
    int start = free(grid, random);
    search.plan(start);

    double trembles = 0.4 * FRAME.cellM() * (2.0 * random.nextDouble() - 1.0);
    assertThat(search.isFor(grid, north + trembles, east - trembles)).isTrue();
    assertThat(search.isFor(grid, north + FRAME.cellM(), east)).isFalse();
    search.plan(start);
    assertThat(search.expanded()).isZero();
  }

  @Example
  void plan_obstaclesThatTouchAtTheirCorners_areNoWay() {
    CostGrid grid = new CostGrid(FRAME, new Inflation(0.1, 2.0, 3.0));
    int start = FRAME.index(0, SIZE - 1);
    int goal = FRAME.index(SIZE - 1, 0);
    DStarLite repaired = new DStarLite(grid, FRAME.centreNorthM(goal), FRAME.centreEastM(goal));
    assertThat(repaired.plan(start)).isPresent();

    grid.update(i -> i / SIZE == i % SIZE, i -> false); // between start and goal

    assertThat(repaired.plan(start)).isEmpty();
    assertThat(plan(new ThetaStar(false), grid, start, goal)).isEmpty();
    assertThat(plan(new ThetaStar(), grid, start, goal)).isEmpty();
    assertThat(
            grid.straightCost(
                FRAME.centreNorthM(start),
                FRAME.centreEastM(start),
                FRAME.centreNorthM(goal),
                FRAME.centreEastM(goal)))
        .isInfinite();
  }

  static Optional<GridPath> plan(ThetaStar search, CostGrid grid, int start, int goal) {
    return search.plan(grid, start, FRAME.centreNorthM(goal), FRAME.centreEastM(goal));
  }

  private static CostGrid grid(Random random) {
    CostGrid grid = new CostGrid(FRAME, INFLATION);
    boolean[] occupied = new boolean[SIZE * SIZE];
    int blocks = random.nextInt(24);
    for (int k = 0; k < blocks; k++) {
      int row = random.nextInt(SIZE);
      int column = random.nextInt(SIZE);
      for (int i = 0; i < 1 + random.nextInt(5); i++) {
        occupied[Math.min(SIZE - 1, row + i) * SIZE + column] = true;
      }
    }
    int edge = random.nextInt(SIZE);
    grid.update(i -> occupied[i], i -> i % SIZE > edge);
    return grid;
  }

  private static int free(CostGrid grid, Random random) {
    int cell;
    do {
      cell = random.nextInt(SIZE * SIZE);
    } while (!grid.isFree(cell));
    return cell;
  }

  static double[] bellmanFord(CostGrid grid, int start) {
    double[] costs = new double[grid.frame().cells()];
    Arrays.fill(costs, Double.POSITIVE_INFINITY);
    costs[start] = 0.0;
    boolean changed = true;
    while (changed) {
      changed = false;
      for (int i = 0; i < costs.length; i++) {
        for (int k = 0; k < 9; k++) {
          int row = i / SIZE + k / 3 - 1;
          int column = i % SIZE + k % 3 - 1;
          if (!grid.frame().contains(row, column) || costs[i] == Double.POSITIVE_INFINITY) {
            continue;
          }
          int next = grid.frame().index(row, column);
          double cost =
              costs[i]
                  + 0.5
                      * (grid.cost(i) + grid.cost(next))
                      * 0.5
                      * Math.hypot(row - i / SIZE, column - i % SIZE);
          boolean isClosed = // diagonally between two cells where the vehicle would collide
              !grid.isFree(i / SIZE * SIZE + column) && !grid.isFree(row * SIZE + i % SIZE);
          if (next != i && !isClosed && cost < costs[next] - 1e-12) {
            costs[next] = cost;
            changed = true;
          }
        }
      }
    }
    return costs;
  }
}
