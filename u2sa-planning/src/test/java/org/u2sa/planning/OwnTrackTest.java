package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** A truck that has seen nothing of the ground, and is sent to a goal 3 m behind it. */
class OwnTrackTest extends PlannedVehicle {
  private static final int CELLS = 200;
  private static final double CELL_M = 0.1;

  @BeforeEach
  void start() {
    kit.with("PLANNER", "HYBRID").with("TURN RADIUS", 2.0).with("REVERSES", true);
    kit.with("VEHICLE FRONT", 0.8).with("VEHICLE REAR", 0.2).with("VEHICLE WIDTH", 0.5);
    kit.with("PLANNING SPAN", 20.0).start(PathPlanner::new);
    goals(waypoint("1", 9.0, 0.0).horizontalThreshold(0.3));
  }

  private void at(double north) {
    byte[] cells = new byte[CELLS * CELLS];
    Arrays.fill(cells, OccupancyGrid.UNKNOWN);
    kit.advance(0.1);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of()));
    kit.publish(
        Channels.GRID,
        new OccupancyGrid()
            .anchor(ReferenceFrame.LOCAL_NED, Point.ORIGIN)
            .corner(-0.5 * CELLS * CELL_M, -0.5 * CELLS * CELL_M)
            .resolution(CELL_M)
            .cells(CELLS, cells));
    kit.publish(Channels.STATE, state(north, 0.0, 0.0));
  }

  private boolean backsToAGoalBehind() {
    goals(waypoint("2", 0.0, 0.0).horizontalThreshold(0.3));
    at(3.0);
    return kit.latest(Channels.NAVIGATION).orElseThrow().backwards();
  }

  @Test
  void state_cameFromThere_backsOverItsOwnTrack() {
    for (double north = 0.0; north <= 3.0; north += 0.1) {
      at(north);
    }
    assertThat(backsToAGoalBehind()).isTrue();
  }

  @Test
  void state_beganHere_turnsRound() {
    at(3.0);
    assertThat(backsToAGoalBehind()).isFalse();
  }
}
