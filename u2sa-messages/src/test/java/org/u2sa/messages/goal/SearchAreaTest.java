package org.u2sa.messages.goal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Point;

class SearchAreaTest {
  private static SearchArea area(String corners) {
    List<Point> points = new ArrayList<>();
    for (String corner : corners.split(";")) {
      if (!corner.isEmpty()) {
        String[] place = corner.trim().split(" ");
        points.add(Point.of(Double.parseDouble(place[0]), Double.parseDouble(place[1]), 0.0));
      }
    }
    return new SearchArea().corners(points).resolution(0.05).ground(43.0).uid("a");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | corners: 0 of them; expected 3 to 200",
        "1 1; 2 2 | corners: 2 of them; expected 3 to 200",
        "1 1; 2 2; 3 3 | corners: enclose nothing; expected an outline",
        "1 1; 1 1; 1 1 | corners: enclose nothing; expected an outline",
        "0 0; 2 2; 2 0; 0 2 | corners: the edge after corner 1 crosses the one after corner 3; expected an outline",
        "0 0; 40 0; 40 40; 0 40 | corners: 4100 km from the first one; expected at most 75 km",
        "0 0; 1 0; 1 95 | corners: 1.0 95.0; expected longitude and latitude"
      })
  void fault_outlineThatIsNone_namesIt(String corners, String fault) {
    assertThat(area(corners).fault()).hasValue(fault);
    assertThatThrownBy(() -> area(corners).freeze()).hasMessage("SearchArea: " + fault);
  }

  @Test
  void fault_concaveOutline_none() {
    assertThat(area("0 0; 0.3 0; 0.3 0.1; 0.1 0.1; 0.1 0.3; 0 0.3").fault()).isEmpty();
  }

  @Test
  void fault_concaveOutlineAcrossTheDateLine_none() {
    assertThat(area("179.9 0; -179.8 0; -179.8 0.1; -180 0.1; 180 0.3; 179.9 0.3").fault())
        .isEmpty();
    assertThat(area("-179.9 0; 179.9 0; 179.9 0.1").fault()).isEmpty();
    assertThat(area("179.9 0; -179.9 0.2; -179.9 0; 179.9 0.2").fault().orElseThrow())
        .contains("crosses");
  }

  @Test
  void fault_altitudesThatCannotBeFlown_namesThem() {
    String square = "0 0; 0.1 0; 0.1 0.1; 0 0.1";
    assertThat(area(square).highest(43.0).fault())
        .hasValue("highest: 43.0 m; expected an altitude above the ground, 43.0 m");
    assertThat(area(square).lowest(120.0).highest(100.0).fault())
        .hasValue("lowest: 120.0 m is above highest; expected a lower altitude");
  }

  @Test
  void fault_moreCornersThanAllowed_isRefused() {
    SearchArea many = area("0 0; 1 0; 1 1");
    many.corners(Collections.nCopies(201, Point.of(1.0, 1.0, 0.0)));
    assertThat(many.fault()).hasValue("corners: 201 of them; expected 3 to 200");
  }
}
