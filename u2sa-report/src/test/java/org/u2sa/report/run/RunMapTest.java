package org.u2sa.report.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Polygon;

class RunMapTest {
  @Test
  void map_gridOfALocalFrame_isPlacedByDeadReckoning() throws IOException {
    RunMap map = new RunMap();
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

  @Test
  void take_hugeObjectsAndNames_areThinnedAndCut() {
    RunMap map = new RunMap();
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
}
