package org.u2sa.report.mosaic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;

/** Which positions a mosaic of a recording covers. */
class RecordedMosaicTest {
  private static final List<Geodetic> FLOWN =
      List.of(
          new Geodetic(179.9999, 54.0, 60.0),
          new Geodetic(-179.9999, 54.001, 60.0),
          new Geodetic(-179.9995, 54.0, 60.0));

  private static List<Geodetic> with(Geodetic wrong, int index) {
    List<Geodetic> all = new ArrayList<>(FLOWN);
    all.add(index, wrong);
    return all;
  }

  @Test
  void near_onePositionFarAway_isLeftOutWhereverItIs() {
    for (Geodetic wrong :
        List.of(
            new Geodetic(40.0, 54.0, 60.0),
            new Geodetic(0.0, -54.0, 60.0), // below the others' feet
            new Geodetic(180.0, 54.3, 60.0))) {
      assertThat(RecordedMosaic.near(with(wrong, 0))).containsExactlyElementsOf(FLOWN);
      assertThat(RecordedMosaic.near(with(wrong, 3))).containsExactlyElementsOf(FLOWN);
    }
  }

  @Test
  void near_largeSurvey_keepsAllAndIsRefusedInWords() {
    List<Geodetic> large = with(new Geodetic(180.0, 54.17, 60.0), 3); // 19 km to the north
    assertThat(RecordedMosaic.near(large)).containsExactlyElementsOf(large);
    assertThat(MosaicGrid.around(RecordedMosaic.near(large), 10.0, 10.0).rows()).isEqualTo(1893);

    assertThatThrownBy(() -> MosaicGrid.around(RecordedMosaic.near(large), 0.1, 10.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("a coarser resolution may help");
  }
}
