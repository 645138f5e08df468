package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;

/** Search areas of a multirotor, which flies in any direction without turning. */
class SearchAreaStateTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;
  private static final double SPEED_MPS = 5.0;
  private static final int CELLS = 8; // along each side
  private static final double CELL_M = 4.0;

  private Point at = Point.ORIGIN; // north, east

  private void start() {
    kit.with("SURVEY FOCAL LENGTH", 300.0).with("SURVEY PIXELS", 320.0);
    kit.with("SURVEY LEAD IN", 5.0).with("LOOK AHEAD", 5.0).with("PLANNED SPEED", SPEED_MPS);
    kit.start(PathPlanner::new);
    SearchArea area = new SearchArea().corners(corners()).resolution(0.05);
    goals(area.ground(-20.0).uid("a").referenceFrame(ReferenceFrame.LOCAL_NED));
  }

  private static List<Point> corners() {
    double side = CELLS * CELL_M;
    return List.of(Point.of(0.0, 0.0, 0.0), Point.of(side, 0.0, 0.0), Point.of(side, side, 0.0));
  }

  /** The record of a camera that has seen nothing. */
  private static CoverageLedger ledger(ReferenceFrame frame) {
    int count = CELLS * CELLS;
    CoverageLedger ledger = new CoverageLedger().points(corners()).area("a");
    ledger.uid("seen").objectType("search area").referenceFrame(frame).x(0.0).y(0.0);
    return ledger.cells(
        Point.ORIGIN, CELL_M, CELLS, new byte[count], new byte[count], new byte[2 * count]);
  }

  private void fly(double seconds, ReferenceFrame recordedIn) {
    for (double gone = 0.0; gone < seconds; gone += STEP_S) {
      kit.advance(STEP_S);
      kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(ledger(recordedIn))));
      kit.publish(Channels.STATE, state(at.x(), at.y(), 0.0));
      Optional<NavigationPoint> newest = kit.latest(Channels.NAVIGATION);
      if (newest.isEmpty()) {
        continue; // nowhere to fly
      }
      Point to = new Attitude(0.0, 0.0, 0.0).nedOf(newest.get().point());
      double away = Math.hypot(to.x(), to.y());
      double mps = Math.min(SPEED_MPS, newest.get().speed().orElse(SPEED_MPS));
      double move = Math.min(1.0, mps * STEP_S / Math.max(1.0e-6, away));
      at = at.plus(Point.of(to.x(), to.y(), 0.0).times(move));
    }
  }

  @Test
  void plan_turnsInPlace_fliesItsLanesWithoutWaiting() {
    start();
    fly(1.0, ReferenceFrame.LOCAL_NED);
    assertThat(logged("pass 1: ")).isEqualTo(1);
    assertThat(logged("pass 2: ")).isZero();
    fly(50.0, ReferenceFrame.LOCAL_NED);
    assertThat(logged("pass 2: ")).isEqualTo(1);
  }

  @Test
  void plan_lanesCannotBeLaid_isNoPass() {
    start();
    fly(3.0, ReferenceFrame.GLOBAL);
    assertThat(logged("no navigation points")).isEqualTo(1);
    assertThat(logged("given up")).isZero();
  }
}
