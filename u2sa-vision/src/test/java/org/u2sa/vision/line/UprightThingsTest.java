package org.u2sa.vision.line;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

/** Lines on the ground and poles, as traced from above: x ahead, y to the right. */
class UprightThingsTest {
  private static final Point CAMERA = Point.of(0.1, 0.0, -1.1);

  private static List<Point> straight(double x, double y, double toX, double toY) {
    List<Point> points = new ArrayList<>();
    int steps = (int) Math.ceil(Math.hypot(toX - x, toY - y) / 0.12);
    for (int i = 0; i <= steps; i++) {
      double share = (double) i / steps;
      points.add(Point.of(x + share * (toX - x), y + share * (toY - y), 0.0));
    }
    return points;
  }

  @Test
  void cutOut_lineBesideTheVehicle_staysWhole() {
    List<Point> line = straight(1.0, 1.5, 7.0, 1.5);
    assertThat(UprightThings.cutOut(line, CAMERA)).containsExactly(line);
  }

  @Test
  void cutOut_pole_isGone() {
    assertThat(UprightThings.cutOut(straight(3.1, 1.0, 6.1, 2.0), CAMERA)).isEmpty();
  }

  @Test
  void cutOut_lineThatBeginsCloseAhead_staysWhole() {
    List<Point> line = straight(2.2, 0.0, 8.0, 0.0);
    assertThat(UprightThings.cutOut(line, CAMERA)).containsExactly(line);
    Collections.reverse(line);
    assertThat(UprightThings.cutOut(line, CAMERA)).containsExactly(line);
  }

  @Test
  void cutOut_poleAhead_isGone() {
    assertThat(UprightThings.cutOut(straight(3.2, 0.0, 8.0, 0.0), CAMERA)).isEmpty();
  }

  @Test
  void cutOut_lineAcross_staysWhole() {
    List<Point> line = straight(4.0, -2.0, 4.0, 2.0);
    assertThat(UprightThings.cutOut(line, CAMERA)).containsExactly(line);
  }

  @Test
  void cutOut_poleThatRunsIntoALine_leavesTheLine() {
    List<Point> chain = straight(2.1, 0.5, 5.1, 1.25);
    List<Point> line = straight(5.1, 1.37, 5.1, 3.0);
    chain.addAll(line);
    assertThat(UprightThings.cutOut(chain, CAMERA))
        .singleElement()
        .satisfies(part -> assertThat(part).allMatch(point -> point.x() > 4.5))
        .satisfies(part -> assertThat(part.size()).isGreaterThan(line.size() - 3));
  }

  @Test
  void cutOut_bendsTangent_isNoPole() {
    List<Point> bend = new ArrayList<>();
    for (int i = 0; i < 30; i++) { // a circle of 2 m, whose tangent runs through below the camera
      double angle = -1.3 + 0.06 * i;
      bend.add(Point.of(4.0 + 2.0 * Math.cos(angle), 2.0 + 2.0 * Math.sin(angle), 0.0));
    }
    assertThat(UprightThings.cutOut(bend, CAMERA)).containsExactly(bend);
  }
}
