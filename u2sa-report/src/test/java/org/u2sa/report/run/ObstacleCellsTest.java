package org.u2sa.report.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

class ObstacleCellsTest {
  private static final byte OCCUPIED = 120;
  private static final byte FREE = -120;

  private static OccupancyGrid grid(int columns, byte[] cells) {
    return new OccupancyGrid()
        .anchor(ReferenceFrame.GLOBAL, Point.of(179.9999, 48.0, 0.0))
        .corner(-20.03, -13.07)
        .resolution(0.25)
        .cells(columns, cells);
  }

  private static Function<Point, Optional<Point>> map() {
    Geodetic origin = new Geodetic(179.998, 48.001, 0.0);
    return point -> Optional.of(origin.enuOf(Geodetic.of(point)));
  }

  private static Set<List<Integer>> squares(String json) {
    String list = json.replaceFirst(".*\"squares\":\\[([^]]*)].*", "$1");
    Set<List<Integer>> squares = new LinkedHashSet<>();
    String[] numbers = list.isEmpty() ? new String[0] : list.split(",");
    for (int i = 0; i < numbers.length; i += 2) {
      squares.add(
          List.of(Integer.parseInt(numbers[i].trim()), Integer.parseInt(numbers[i + 1].trim())));
    }
    return squares;
  }

  @ParameterizedTest
  @CsvSource({"160, 120", "1, 50", "50, 1", "1, 1"})
  void take_gridOnTheEarth_marksTheSquaresOfItsCells(int columns, int rows) {
    byte[] cells = new byte[columns * rows];
    Random random = new Random(columns);
    for (int i = 0; i < cells.length; i++) {
      cells[i] = random.nextInt(3) == 0 ? OCCUPIED : OccupancyGrid.UNKNOWN;
    }
    cells[0] = OCCUPIED;
    OccupancyGrid grid = grid(columns, cells);
    Set<List<Integer>> expected = new LinkedHashSet<>();
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        if (cells[row * columns + column] == OCCUPIED) {
          Point at = map().apply(grid.centerOf(column, row)).orElseThrow();
          expected.add(List.of((int) Math.floor(at.x() / 0.2), (int) Math.floor(at.y() / 0.2)));
        }
      }
    }
    ObstacleCells obstacles = new ObstacleCells();
    obstacles.take(grid, map());
    assertThat(squares(obstacles.json().line())).isEqualTo(expected).isNotEmpty();
  }

  @Test
  void take_cellSeenFreeLater_isNoObstacle() {
    ObstacleCells obstacles = new ObstacleCells();
    obstacles.take(grid(2, new byte[] {OCCUPIED, OCCUPIED}), map());
    obstacles.take(grid(2, new byte[] {FREE, OccupancyGrid.UNKNOWN}), map());
    assertThat(squares(obstacles.json().line())).hasSize(1);
  }

  @Test
  void take_largeGrid_placesFourPointsOnly() {
    int[] placed = {0};
    new ObstacleCells()
        .take(
            grid(500, new byte[500 * 500]),
            point -> {
              placed[0]++;
              return map().apply(point);
            });
    assertThat(placed[0]).isEqualTo(4);
  }

  @Test
  void take_gridWithoutAPlaceOnTheMap_isLeftOut() {
    ObstacleCells obstacles = new ObstacleCells();
    obstacles.take(grid(1, new byte[] {OCCUPIED}), point -> Optional.empty());
    assertThat(squares(obstacles.json().line())).isEmpty();
  }
}
