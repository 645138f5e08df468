package org.u2sa.vision.line;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.vision.ground.TopView;

class SummedAreaTest {
  private static final TopView.Area AREA = new TopView.Area(1.0, 2.0, 0.6, 0.1);

  @Test
  void mean_ofAStrip_isThatOfTheRectangle() {
    SummedArea area = new SummedArea(AREA);
    byte[] shades = new byte[AREA.rows() * AREA.columns()];
    boolean[] seen = new boolean[shades.length];
    Random random = new Random(3L);
    random.nextBytes(shades);
    for (int i = 0; i < seen.length; i++) {
      seen[i] = random.nextInt(4) > 0;
    }
    area.take(shades, seen);
    long[] strip = new long[AREA.columns() + 1];
    for (int row = -4; row < AREA.rows() + 4; row++) {
      area.strip(row, row + 3, strip);
      for (int column = -6; column < AREA.columns() + 6; column++) {
        assertThat(SummedArea.mean(strip, column, column + 4, 2))
            .as("row %d, column %d", row, column)
            .isEqualTo(area.mean(row, column, row + 3, column + 4, 2));
      }
    }
  }
}
