package org.u2sa.messages.frame;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GeodeticTest {
  @Test
  void constructor_outOfRange_namesValueAndBounds() {
    assertThatThrownBy(() -> new Geodetic(0.0, 90.1, 0.0))
        .hasMessage("latitude: 90.1 deg is outside -90…90 deg");
    assertThatThrownBy(() -> new Geodetic(0.0, Double.NaN, 0.0))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Geodetic(Double.POSITIVE_INFINITY, 0.0, 0.0))
        .hasMessageContaining("longitude");
    assertThatThrownBy(() -> new Geodetic(0.0, 0.0, Double.NaN)).hasMessageContaining("altitude");
  }

  @Test
  void constructor_longitudeBeyondTheDateLine_isWrapped() {
    assertThat(new Geodetic(190.0, 0.0, 0.0).longitudeDeg()).isEqualTo(-170.0);
    assertThat(new Geodetic(-190.0, 0.0, 0.0).longitudeDeg()).isEqualTo(170.0);
    assertThat(new Geodetic(180.0, 0.0, 0.0).longitudeDeg()).isEqualTo(180.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-90.0, -89.9999, -45.0, 0.0, 1e-9, 45.0, 89.9999, 90.0})
  void fromEnu_atAnyLatitude_isTheInverseOfEnuOf(double latitude) {
    Geodetic origin = new Geodetic(12.0, latitude, 100.0);
    Point enu = Point.of(3000.0, -4000.0, 250.0);

    assertThat(origin.enuOf(origin.fromEnu(enu)).distanceTo(enu)).isLessThan(1e-6);
    Point ned = Point.of(-4000.0, 3000.0, -250.0);
    assertThat(origin.nedOf(origin.fromNed(ned)).distanceTo(ned)).isLessThan(1e-6);
  }

  @Test
  void enuOf_acrossTheDateLine_isShort() {
    Geodetic west = new Geodetic(179.9999, 10.0, 0.0);
    Geodetic east = new Geodetic(-179.9999, 10.0, 0.0);

    assertThat(west.enuOf(east).x()).isCloseTo(west.distanceM(east), within(1e-3));
    assertThat(west.bearingRad(east)).isCloseTo(Math.PI / 2.0, within(1e-4));
    assertThat(east.bearingRad(west)).isCloseTo(1.5 * Math.PI, within(1e-4));
  }

  @ParameterizedTest
  @CsvSource({
    "-157.9, 21.3, UTM 4N",
    "-180, 0, UTM 1N",
    "180, -1, UTM 60S",
    "5, 60, UTM 32N",
    "2.9, 60, UTM 31N",
    "8, 75, UTM 31N",
    "10, 75, UTM 33N",
    "22, 75, UTM 35N",
    "34, 75, UTM 37N"
  })
  void frameAt_place_isItsZone(double longitude, double latitude, String name) {
    assertThat(UtmGrid.frameAt(new Geodetic(longitude, latitude, 0.0)).name()).isEqualTo(name);
  }

  @Test
  void grid_otherSideOfTheEarth_isRefused() {
    UtmGrid grid = new UtmGrid(ReferenceFrame.utm(4, true));

    assertThatThrownBy(() -> grid.grid(new Geodetic(-69.0, 0.0, 0.0)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("UTM 4N");
    assertThatThrownBy(() -> new UtmGrid(ReferenceFrame.GLOBAL)).hasMessageContaining("GLOBAL");
  }
}
