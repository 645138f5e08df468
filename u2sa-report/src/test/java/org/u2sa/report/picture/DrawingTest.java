package org.u2sa.report.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.report.EscapedXml;

class DrawingTest {

  @Test
  void colours_scale_clampsItsEnds() {
    assertThat(ColourScale.step(-5.0, 0.0, 10.0)).isZero();
    assertThat(ColourScale.step(50.0, 0.0, 10.0)).isEqualTo(ColourScale.STEPS - 1);
    assertThat(ColourScale.step(1.0, 3.0, 3.0)).isZero();
    assertThat(ColourScale.colour(0)).isEqualTo(new Color(0x440154));
    assertThat(ColourScale.colour(ColourScale.STEPS - 1)).isEqualTo(new Color(0xa5db36));
  }

  @Test
  void place_crowdedPoints_overlapNothing() {
    LabelPlacer placer = new LabelPlacer(new Rectangle2D.Double(0.0, 0.0, 400.0, 300.0));
    List<Rectangle2D.Double> labels = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      labels.add(placer.place(200.0 + 6.0 * i, 150.0, 5.0, 60.0, 16.0));
    }
    for (int i = 0; i < labels.size(); i++) {
      for (int k = 0; k < i; k++) {
        assertThat(LabelPlacer.overlap(labels.get(i), labels.get(k))).isZero();
      }
    }
  }

  @Test
  void place_pointInTheCorner_staysInTheFrame() {
    Rectangle2D.Double frame = new Rectangle2D.Double(0.0, 0.0, 400.0, 300.0);
    assertThat(frame.contains(new LabelPlacer(frame).place(399.0, 1.0, 5.0, 80.0, 16.0))).isTrue();
  }

  @Test
  void middle_polygonOverTheAntimeridian_isInIt() {
    Polygon area =
        new Polygon()
            .points(
                List.of(
                    Point.of(179.99, 10.0, 0.0),
                    Point.of(-179.97, 10.0, 0.0),
                    Point.of(-179.97, 10.02, 0.0),
                    Point.of(179.99, 10.02, 0.0)));
    area.referenceFrame(ReferenceFrame.GLOBAL);

    Point middle = ObstacleLayer.middle(area);

    assertThat(middle.x()).isCloseTo(-179.99, within(1e-5));
    assertThat(middle.y()).isCloseTo(10.01, within(1e-5));
  }

  @Test
  void escaped_markupAndControls_isSafeXml() {
    assertThat(EscapedXml.of("a<b>&\"c\"\u0000\ud83d\ude81"))
        .isEqualTo("a&lt;b&gt;&amp;&quot;c&quot;\ufffd\ud83d\ude81");
  }
}
