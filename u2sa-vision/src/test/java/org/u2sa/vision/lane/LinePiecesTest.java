package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.world.modeller.MapFrame;

/** Pieces of lines along x, as the vehicle at the origin publishes them. */
class LinePiecesTest {
  private final LinePieces pieces = new LinePieces(MapFrame.BODY, "line", Point.ORIGIN, 0.6);

  private static List<Point> line(double fromX, double toX, double y) {
    List<Point> points = new ArrayList<>();
    for (double x = fromX; x <= toX; x += LineSamples.STEP_M) {
      points.add(Point.of(x, y, 0.0));
    }
    return points;
  }

  private static double nearest(ObjectDescription piece) {
    return ((PolyLine) piece)
        .points().stream().mapToDouble(at -> Math.hypot(at.x(), at.y())).min().orElseThrow();
  }

  private List<Double> confidences() {
    return pieces.all().stream().map(each -> each.confidence().orElseThrow()).toList();
  }

  @Test
  void certain_anyDistance_isCertain() {
    pieces.certain(line(0.0, 20.0, 2.0));
    assertThat(confidences()).hasSizeGreaterThan(5).containsOnly(1.0);
  }

  @Test
  void guessed_sideOfALane_isBelievedNearTheVehicleOnly() {
    pieces.guessed(line(0.0, 20.0, 2.0), piece -> true);
    assertThat(pieces.all())
        .allSatisfy(
            piece ->
                assertThat(piece.confidence())
                    .hasValue(nearest(piece) < 3.0 ? LinePieces.SIDE : LinePieces.GUESS));
    assertThat(confidences()).contains(LinePieces.SIDE, LinePieces.GUESS);
  }

  @Test
  void guessed_noSideOfALane_isAGuess() {
    pieces.guessed(line(0.0, 20.0, 2.0), piece -> false);
    pieces.uncertain(line(0.0, 20.0, 2.0), piece -> false);
    assertThat(confidences()).containsOnly(LinePieces.GUESS);
  }

  @Test
  void inferred_underTheVehicle_isLeftOut() {
    pieces.inferred(line(-3.0, 3.0, 0.0), LinePieces.DRIVEN);
    assertThat(pieces.all())
        .isNotEmpty()
        .allSatisfy(p -> assertThat(nearest(p)).isGreaterThanOrEqualTo(0.6));
  }
}
