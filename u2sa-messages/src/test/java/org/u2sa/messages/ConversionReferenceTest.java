package org.u2sa.messages;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceCsv;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Conversions of whole messages against values composed by scripts/geodesy-reference.py (PROJ and
 * quaternions).
 */
class ConversionReferenceTest {
  private static final double METRES = 2e-6;
  private static final double RADIANS = 1e-9;

  static Stream<ReferenceCsv> states() throws IOException {
    return ReferenceCsv.rows("state.csv");
  }

  static Stream<ReferenceCsv> bodyPoints() throws IOException {
    return ReferenceCsv.rows("body.csv");
  }

  private static StateInformation global(ReferenceCsv row) {
    return new StateInformation()
        .x(row.number("lonDeg"))
        .y(row.number("latDeg"))
        .z(row.number("altM"))
        .xDot(row.number("eastMps"))
        .yDot(row.number("northMps"))
        .zDot(row.number("upMps"))
        .phi(row.number("phi"))
        .theta(row.number("theta"))
        .psi(row.number("psi"));
  }

  private static Geodetic origin(ReferenceCsv row) {
    return row.place("originLonDeg", "originLatDeg", "originAltM");
  }

  private static void assertAngle(OptionalDouble actual, double expected) {
    assertThat(Math.IEEEremainder(actual.getAsDouble() - expected, 2.0 * Math.PI))
        .isCloseTo(0.0, within(RADIANS));
  }

  private static void assertMetres(OptionalDouble actual, double expected) {
    assertThat(actual.getAsDouble()).isCloseTo(expected, within(METRES));
  }

  @ParameterizedTest
  @MethodSource("states")
  void in_localNed_placeVelocityAndAttitudeAreTheReference(ReferenceCsv row) {
    StateInformation ned = global(row).in(ReferenceFrame.LOCAL_NED, origin(row));

    assertMetres(ned.x(), row.number("nM"));
    assertMetres(ned.y(), row.number("eM"));
    assertMetres(ned.z(), row.number("dM"));
    assertMetres(ned.xDot(), row.number("vnMps"));
    assertMetres(ned.yDot(), row.number("veMps"));
    assertMetres(ned.zDot(), row.number("vdMps"));
    assertAngle(ned.phi(), row.number("nedPhi"));
    assertAngle(ned.theta(), row.number("nedTheta"));
    assertAngle(ned.psi(), row.number("nedPsi"));
  }

  @ParameterizedTest
  @MethodSource("states")
  void in_localEnu_attitudeIsThatOfFluAxes(ReferenceCsv row) {
    StateInformation enu = global(row).in(ReferenceFrame.LOCAL_ENU, origin(row));

    assertMetres(enu.x(), row.number("eM"));
    assertMetres(enu.y(), row.number("nM"));
    assertMetres(enu.zDot(), -row.number("vdMps"));
    assertAngle(enu.phi(), row.number("enuPhi"));
    assertAngle(enu.theta(), row.number("enuTheta"));
    assertAngle(enu.psi(), row.number("enuPsi"));
  }

  @ParameterizedTest
  @MethodSource("states")
  void in_localAndBack_restoresTheState(ReferenceCsv row) {
    StateInformation state = global(row);
    StateInformation back =
        state.in(ReferenceFrame.LOCAL_ENU, origin(row)).in(ReferenceFrame.GLOBAL, origin(row));

    assertThat(back.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(back.presenceVector()).isEqualTo(state.presenceVector());
    assertThat(back.x().getAsDouble()).isCloseTo(state.x().getAsDouble(), within(1e-10));
    assertThat(back.y().getAsDouble()).isCloseTo(state.y().getAsDouble(), within(1e-10));
    assertMetres(back.z(), row.number("altM"));
    assertMetres(back.xDot(), row.number("eastMps"));
    assertAngle(back.phi(), row.number("phi"));
    assertAngle(back.theta(), row.number("theta"));
    assertAngle(back.psi(), row.number("psi"));
  }

  @ParameterizedTest
  @MethodSource("bodyPoints")
  void in_body_pointIsWhereTheVehicleSeesIt(ReferenceCsv row) {
    NavigationPoint point =
        NavigationPoint.at(row.place("pointLonDeg", "pointLatDeg", "pointAltM").point())
            .referenceFrame(ReferenceFrame.GLOBAL);
    StateInformation vehicle =
        new StateInformation()
            .x(row.number("lonDeg"))
            .y(row.number("latDeg"))
            .z(row.number("altM"))
            .phi(row.number("phi"))
            .theta(row.number("theta"))
            .psi(row.number("psi"));

    Point frd = point.in(ReferenceFrame.BODY_FRD, vehicle).point();
    Point body = point.in(ReferenceFrame.BODY, vehicle).point();
    Point flu = point.in(ReferenceFrame.BODY_FLU, vehicle).point();

    double f = row.number("forwardM");
    double r = row.number("rightM");
    double d = row.number("downM");
    assertThat(frd.distanceTo(Point.of(f, r, d))).isLessThan(METRES);
    assertThat(body.distanceTo(Point.of(f, -r, d))).isLessThan(METRES);
    assertThat(flu.distanceTo(Point.of(f, -r, -d))).isLessThan(METRES);
    Point back = point.in(ReferenceFrame.BODY, vehicle).in(ReferenceFrame.GLOBAL, vehicle).point();
    assertThat(Geodetic.of(back).enuOf(Geodetic.of(point.point())).distance()).isLessThan(METRES);
  }
}
