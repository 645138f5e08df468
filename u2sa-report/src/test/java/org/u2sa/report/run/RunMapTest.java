package org.u2sa.report.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Polygon;

class RunMapTest {
  @Test
  void map_gridOfALocalFrame_isPlacedByDeadReckoning() throws IOException {
    RunMap map = new RunMap(Optional.empty());
    map.take(0.0, new StateInformation().sensorName("e").x(8.0).y(50.0));
    StateInformation local = new StateInformation().sensorName("e");
    map.takeLocal(local.referenceFrame(ReferenceFrame.LOCAL_ENU).x(100.0).y(200.0));
    OccupancyGrid grid =
        new OccupancyGrid()
            .anchor(ReferenceFrame.LOCAL_ENU, Point.of(103.0, 204.0, 0.0))
            .corner(0.0, 0.0)
            .resolution(0.2)
            .cells(2, new byte[] {100, OccupancyGrid.UNKNOWN});
    map.take(grid);
    JsonNode cells =
        new ObjectMapper().readTree(map.json(null, 0.0).line()).get("cells").get("squares");
    assertThat(cells).hasSize(2);
    assertThat(cells.get(0).asInt()).isEqualTo(15); // 3.1 m east
    assertThat(cells.get(1).asInt()).isEqualTo(20); // 4.1 m north
    map.take(grid.copy().cells(2, new byte[] {-100, OccupancyGrid.UNKNOWN}));
    assertThat(map.json(null, 0.0).line()).contains("\"squares\":[]");
  }

  private static Box box(ReferenceFrame frame, double x, double y, double psi) {
    Box box = new Box().length(4.0).width(2.0).height(1.0).psi(psi);
    box.uid("box").referenceFrame(frame).x(x).y(y);
    return box;
  }

  /** Extent of an object's outline: east, north [m]. */
  private static double[] extent(RunMap map) throws IOException {
    JsonNode outline =
        new ObjectMapper().readTree(map.json(null, 0.0).line()).at("/objects/0/outline");
    double[] values = new double[outline.size()];
    Arrays.setAll(values, i -> outline.get(i).asDouble());
    return new double[] {span(values, 0), span(values, 1)};
  }

  private static double span(double[] values, int from) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = from; i < values.length; i += 2) {
      least = Math.min(least, values[i]);
      most = Math.max(most, values[i]);
    }
    return most - least;
  }

  @Test
  void map_box_liesAsItsFrameTurns() throws IOException {
    Map<ReferenceFrame, Double> eastward =
        Map.of(ReferenceFrame.LOCAL_ENU, 0.0, ReferenceFrame.LOCAL_NED, Math.PI / 2.0);
    for (Map.Entry<ReferenceFrame, Double> each : eastward.entrySet()) {
      RunMap map = new RunMap(Optional.empty());
      map.take(0.0, new StateInformation().sensorName("e").x(8.0).y(50.0));
      map.takeLocal(
          new StateInformation().sensorName("e").referenceFrame(each.getKey()).x(0.0).y(0.0));
      map.take(new ObjectList().objects(List.of(box(each.getKey(), 5.0, 5.0, each.getValue()))));

      assertThat(extent(map))
          .as(each.getKey().name())
          .containsExactly(new double[] {4.0, 2.0}, within(1e-6));
    }
  }

  @Test
  void map_objectAndGoalInUtm_areDrawn() throws IOException {
    RunMap map = new RunMap(Optional.empty());
    map.take(0.0, new StateInformation().sensorName("e").x(9.0).y(50.0));
    Point grid = new UtmGrid(ReferenceFrame.utm(32, true)).grid(new Geodetic(9.0, 50.0, 0.0));
    ReferenceFrame utm = ReferenceFrame.utm(32, true);
    map.take(new ObjectList().objects(List.of(box(utm, grid.x() + 10.0, grid.y(), 0.0))));
    Waypoint goal = new Waypoint().horizontalThreshold(1.0).referenceFrame(utm);
    map.take(goal.uid("g").x(grid.x()).y(grid.y() + 20.0));

    assertThat(extent(map)).containsExactly(new double[] {2.0, 4.0}, within(1e-6));
    assertThat(map.goal("g").orElseThrow().y()).isCloseTo(20.0, within(0.01));
  }

  @Test
  void take_placesThatAreNone_areLeftOut() throws IOException {
    RunMap map = new RunMap(Optional.empty());
    map.take(0.0, new StateInformation().sensorName("e").x(9.0).y(50.0));
    map.take(
        new ObjectList()
            .objects(
                List.of(
                    box(ReferenceFrame.GLOBAL, 9.0, 95.0, 0.0),
                    box(ReferenceFrame.utm(32, true), 1.0e9, -1.0e9, 0.0))));

    assertThat(new ObjectMapper().readTree(map.json(null, 0.0).line()).get("objects")).isEmpty();
  }

  @Test
  void take_hugeObjectsAndNames_areThinnedAndCut() {
    RunMap map = new RunMap(Optional.empty());
    map.take(0.0, new StateInformation().sensorName("e").x(8.0).y(50.0));
    List<Point> corners =
        IntStream.range(0, 90_000)
            .mapToObj(n -> Point.of(8.0 + 1e-9 * n, 50.0 + 1e-9 * (n % 2), 0.0))
            .toList();
    Polygon wall = new Polygon().points(corners);
    wall.uid("w".repeat(1_000)).x(8.0).y(50.0).referenceFrame(ReferenceFrame.GLOBAL);
    map.take(new ObjectList().objects(List.of(wall)));
    Waypoint goal =
        new Waypoint()
            .horizontalThreshold(1.0)
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(8.0)
            .y(50.0);
    map.take(goal.uid("g".repeat(1_000)));

    assertThat(map.json(null, 0.0).line())
        .hasSizeLessThan(40_000)
        .contains("www… (1000 characters)", "ggg… (1000 characters)");
  }

  @Test
  void take_stateOnAGrid_isOnTheMap() {
    Geodetic place = new Geodetic(8.001, 50.0, 0.0);
    ReferenceFrame grid = UtmGrid.frameAt(place);
    Point at = new UtmGrid(grid).grid(place);
    RunMap map = new RunMap(Optional.empty());
    map.take(0.0, new StateInformation().sensorName("e").x(8.0).y(50.0));

    StateInformation state = new StateInformation().sensorName("e").referenceFrame(grid);
    Point point = map.take(1.0, state.x(at.x()).y(at.y())).orElseThrow();

    assertThat(point.x()).isCloseTo(71.7, within(0.1));
    assertThat(point.y()).isCloseTo(0.0, within(0.01));
  }

  private static double eastOf(RunMap map) throws IOException {
    JsonNode json = new ObjectMapper().readTree(map.json(null, 0.0).line());
    return json.get("track").get(1).asDouble();
  }

  @Test
  void map_originOfAnotherRunNearby_isShared() throws IOException {
    RunMap map = new RunMap(Optional.of(new Geodetic(8.0, 0.0, 0.0)));
    map.take(0.0, new StateInformation().sensorName("e").x(8.0001).y(0.0));

    assertThat(eastOf(map)).isCloseTo(11.13, within(0.01));
    assertThat(map.json(null, 0.0).line()).contains("\"isShared\":true");
  }

  @Test
  void map_originOfAnotherRunFarAway_isNotShared() throws IOException {
    RunMap map = new RunMap(Optional.of(new Geodetic(9.0, 0.0, 0.0)));
    map.take(0.0, new StateInformation().sensorName("e").x(8.0001).y(0.0));

    assertThat(eastOf(map)).isZero();
    assertThat(map.json(null, 0.0).line()).contains("\"isShared\":false");
  }
}
