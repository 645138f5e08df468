package org.u2sa.messages.frame;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Geodesy against PROJ. */
class GeodesyReferenceTest {
  private static final Offset<Double> MICROMETRE = within(1e-6);
  private static final Offset<Double> MICROMETRE_IN_DEG = within(1e-11);

  static Stream<ReferenceCsv> utm() throws IOException {
    return ReferenceCsv.rows("utm.csv");
  }

  static Stream<ReferenceCsv> enu() throws IOException {
    return ReferenceCsv.rows("enu.csv");
  }

  static Stream<ReferenceCsv> geodesic() throws IOException {
    return ReferenceCsv.rows("geodesic.csv");
  }

  @ParameterizedTest
  @MethodSource("utm")
  void grid_placesOfAllZones_areThoseOfProj(ReferenceCsv row) {
    UtmGrid grid = gridOf(row);
    Point point = grid.grid(new Geodetic(row.number("lonDeg"), row.number("latDeg"), 12.0));

    assertThat(point.x()).isCloseTo(row.number("eastingM"), MICROMETRE);
    assertThat(point.y()).isCloseTo(row.number("northingM"), MICROMETRE);
    assertThat(point.z()).isEqualTo(12.0);
  }

  @ParameterizedTest
  @MethodSource("utm")
  void place_gridOfAllZones_isThatOfProj(ReferenceCsv row) {
    Geodetic place =
        gridOf(row).place(Point.of(row.number("eastingM"), row.number("northingM"), 0.0));

    double shrink = Math.cos(Math.toRadians(row.number("latDeg")));
    double across = Math.IEEEremainder(place.longitudeDeg() - row.number("lonDeg"), 360.0);
    assertThat(across * shrink).isCloseTo(0.0, MICROMETRE_IN_DEG);
    assertThat(place.latitudeDeg()).isCloseTo(row.number("latDeg"), MICROMETRE_IN_DEG);
  }

  @ParameterizedTest
  @MethodSource("utm")
  void convergenceAndScale_allZones_areThoseOfProj(ReferenceCsv row) {
    UtmGrid grid = gridOf(row);
    Geodetic place = new Geodetic(row.number("lonDeg"), row.number("latDeg"), 0.0);

    assertThat(grid.convergenceRad(place))
        .isCloseTo(Math.toRadians(row.number("convergenceDeg")), within(1e-7));
    assertThat(grid.scale(place)).isCloseTo(row.number("scale"), within(1e-8));
  }

  @ParameterizedTest
  @MethodSource("enu")
  void enuOf_placesNearAndFar_areThoseOfProj(ReferenceCsv row) {
    Point enu = origin(row).enuOf(row.place("lon2Deg", "lat2Deg", "alt2M"));

    assertThat(enu.x()).isCloseTo(row.number("eastM"), MICROMETRE);
    assertThat(enu.y()).isCloseTo(row.number("northM"), MICROMETRE);
    assertThat(enu.z()).isCloseTo(row.number("upM"), MICROMETRE);
  }

  @ParameterizedTest
  @MethodSource("enu")
  void fromEnu_placesNearAndFar_areThoseOfProj(ReferenceCsv row) {
    Geodetic place =
        origin(row).fromEnu(Point.of(row.number("eastM"), row.number("northM"), row.number("upM")));

    Geodetic expected = row.place("lon2Deg", "lat2Deg", "alt2M");
    assertThat(place.distanceM(expected)).isCloseTo(0.0, MICROMETRE);
    assertThat(place.altitudeM()).isCloseTo(expected.altitudeM(), MICROMETRE);
  }

  @ParameterizedTest
  @MethodSource("geodesic")
  void geodesic_shortAndLong_isThatOfProj(ReferenceCsv row) {
    Geodetic start = new Geodetic(row.number("lonDeg"), row.number("latDeg"), 0.0);
    Geodetic end = new Geodetic(row.number("lon2Deg"), row.number("lat2Deg"), 0.0);
    double azimuth = Math.toRadians(row.number("azimuthDeg"));
    double distance = row.number("distanceM");

    assertThat(start.distanceM(end)).isCloseTo(distance, MICROMETRE);
    double turn = Math.IEEEremainder(start.bearingRad(end) - azimuth, 2.0 * Math.PI);
    assertThat(turn * distance).isCloseTo(0.0, within(1e-3));
    assertThat(start.destination(azimuth, distance).distanceM(end)).isCloseTo(0.0, MICROMETRE);
  }

  private static UtmGrid gridOf(ReferenceCsv row) {
    boolean north = row.text("hemisphere").equals("N");
    return new UtmGrid(ReferenceFrame.utm((int) row.number("zone"), north));
  }

  private static Geodetic origin(ReferenceCsv row) {
    return row.place("lonDeg", "latDeg", "altM");
  }
}
