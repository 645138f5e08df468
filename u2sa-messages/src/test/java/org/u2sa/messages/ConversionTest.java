package org.u2sa.messages;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.Rectangle;

class ConversionTest {
  private static final Offset<Double> EXACT = within(1e-12);
  private static final Geodetic HONOLULU = new Geodetic(-157.92, 21.32, 4.0);

  @Test
  void in_bodyFrames_signsAreThoseOfTheAxes() {
    StateInformation frd =
        new StateInformation()
            .referenceFrame(ReferenceFrame.BODY_FRD)
            .xDot(1.0)
            .yDot(2.0)
            .zDot(3.0)
            .phiDot(0.1) // right wing goes down
            .thetaDot(0.2) // nose goes up
            .psiDot(0.3) // nose goes right
            .fluidyDot(4.0)
            .yDotSigma(0.5);

    StateInformation body = frd.in(ReferenceFrame.BODY);
    StateInformation flu = frd.in(ReferenceFrame.BODY_FLU);

    // Thesis 3.2.3.2: +y left, +z down; phi towards +y (left), theta away from +z (up), psi from +x
    // to +y (left).
    assertThat(body.xDot()).hasValue(1.0);
    assertThat(body.yDot()).hasValue(-2.0);
    assertThat(body.zDot()).hasValue(3.0);
    assertThat(body.phiDot()).hasValue(-0.1);
    assertThat(body.thetaDot()).hasValue(0.2);
    assertThat(body.psiDot()).hasValue(-0.3);
    assertThat(body.fluidyDot()).hasValue(-4.0);
    assertThat(body.yDotSigma()).hasValue(0.5);
    // Right-handed about x forward, y left, z up.
    assertThat(flu.zDot()).hasValue(-3.0);
    assertThat(flu.phiDot()).hasValue(0.1);
    assertThat(flu.thetaDot()).hasValue(-0.2);
    assertThat(flu.psiDot()).hasValue(-0.3);
    assertThat(flu.in(ReferenceFrame.BODY)).isEqualTo(body);
    assertThat(body.in(ReferenceFrame.BODY_FRD)).isEqualTo(frd);
  }

  @Test
  void in_enuAndNed_headingAndAxesChangePlaces() {
    StateInformation ned =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(10.0)
            .y(20.0)
            .z(-30.0)
            .psi(Math.toRadians(30.0))
            .theta(0.1)
            .psiDot(0.2)
            .psiSigma(0.01)
            .xSigma(1.0)
            .ySigma(2.0);

    StateInformation enu = ned.in(ReferenceFrame.LOCAL_ENU);

    assertThat(enu.x()).hasValue(20.0);
    assertThat(enu.y()).hasValue(10.0);
    assertThat(enu.z()).hasValue(30.0);
    assertThat(enu.psi().getAsDouble()).isCloseTo(Math.toRadians(60.0), EXACT);
    assertThat(enu.theta()).hasValue(-0.1);
    assertThat(enu.psiDot()).hasValue(-0.2);
    assertThat(enu.psiSigma()).hasValue(0.01);
    assertThat(enu.xSigma()).hasValue(2.0);
    assertThat(enu.ySigma()).hasValue(1.0);
    assertThat(enu.in(ReferenceFrame.LOCAL_NED).psi().getAsDouble())
        .isCloseTo(ned.psi().getAsDouble(), EXACT);
  }

  @Test
  void in_utm_velocityIsTheDerivativeOfPosition() {
    ReferenceFrame utm = UtmGrid.frameAt(HONOLULU);
    double step = 1e-3;
    Point velocity = Point.of(40.0, 30.0, 2.0);
    StateInformation before = at(HONOLULU).xDot(40.0).yDot(30.0).zDot(2.0);
    Geodetic next =
        HONOLULU.fromEnu(Point.of(velocity.x() * step, velocity.y() * step, velocity.z() * step));

    StateInformation grid = before.in(utm);
    StateInformation later = at(next).in(utm);

    assertThat(utm.name()).isEqualTo("UTM 4N");
    assertThat(grid.xDot().getAsDouble())
        .isCloseTo((later.x().getAsDouble() - grid.x().getAsDouble()) / step, within(1e-3));
    assertThat(grid.yDot().getAsDouble())
        .isCloseTo((later.y().getAsDouble() - grid.y().getAsDouble()) / step, within(1e-3));
    assertThat(grid.zDot().getAsDouble()).isCloseTo(2.0, EXACT);
  }

  @Test
  void in_utm_headingAlongVelocityStaysAlongVelocity() {
    StateInformation state = at(HONOLULU).xDot(40.0).yDot(30.0).psi(Math.atan2(40.0, 30.0));

    StateInformation grid = state.in(UtmGrid.frameAt(HONOLULU));

    assertThat(grid.psi().getAsDouble())
        .isCloseTo(Math.atan2(grid.xDot().getAsDouble(), grid.yDot().getAsDouble()), within(1e-12));
    assertThat(grid.psi().getAsDouble())
        .isNotCloseTo(state.psi().getAsDouble(), within(1e-4)); // convergence
    StateInformation back = grid.in(ReferenceFrame.GLOBAL);
    assertThat(back.psi().getAsDouble()).isCloseTo(state.psi().getAsDouble(), EXACT);
    assertThat(back.xDot().getAsDouble()).isCloseTo(40.0, within(1e-7));
  }

  @Test
  void in_localFarFromOrigin_eulerDerivativesAreThoseOfTheAngles() {
    Geodetic far = HONOLULU.fromEnu(Point.of(300_000.0, 400_000.0, 0.0));
    double h = 1e-3;
    StateInformation[] local = new StateInformation[3];
    for (int i = -1; i <= 1; i++) {
      double t = i * h;
      local[i + 1] =
          at(far)
              .phi(0.3 + 0.2 * t + 0.4 * t * t / 2.0)
              .theta(0.5 - 0.1 * t + 0.3 * t * t / 2.0)
              .psi(1.0 + 0.4 * t - 0.2 * t * t / 2.0)
              .phiDot(0.2)
              .thetaDot(-0.1)
              .psiDot(0.4)
              .phiDoubleDot(0.4)
              .thetaDoubleDot(0.3)
              .psiDoubleDot(-0.2)
              .in(ReferenceFrame.LOCAL_NED, HONOLULU);
    }
    StateInformation now = local[1];

    assertThat(now.phi().getAsDouble()).isNotCloseTo(0.3, within(1e-2));
    StateField[][] fields = {
      {StateField.PHI, StateField.PHI_DOT, StateField.PHI_DOUBLE_DOT},
      {StateField.THETA, StateField.THETA_DOT, StateField.THETA_DOUBLE_DOT},
      {StateField.PSI, StateField.PSI_DOT, StateField.PSI_DOUBLE_DOT}
    };
    for (StateField[] field : fields) {
      double before = local[0].number(field[0]).getAsDouble();
      double here = now.number(field[0]).getAsDouble();
      double after = local[2].number(field[0]).getAsDouble();
      assertThat(now.number(field[1]).getAsDouble())
          .isCloseTo((after - before) / (2.0 * h), within(1e-6));
      assertThat(now.number(field[2]).getAsDouble())
          .isCloseTo((after - 2.0 * here + before) / (h * h), within(1e-5));
    }
  }

  @Test
  void in_onlySomeFieldsSet_noneIsAdded() {
    StateInformation compass = new StateInformation().psi(0.5).psiSigma(0.1);

    assertThat(compass.in(ReferenceFrame.LOCAL_ENU, HONOLULU).presenceVector())
        .isEqualTo(compass.presenceVector());
  }

  @Test
  void in_impossible_namesBothFrames() {
    StateInformation body = new StateInformation().referenceFrame(ReferenceFrame.BODY).xDot(1.0);

    assertThatThrownBy(() -> body.in(ReferenceFrame.GLOBAL))
        .hasMessageStartingWith("StateInformation cannot be converted from BODY to GLOBAL: ");
    assertThatThrownBy(() -> at(HONOLULU).in(ReferenceFrame.LOCAL_NED))
        .hasMessageStartingWith(
            "StateInformation cannot be converted from GLOBAL to LOCAL_NED: the position of");
    assertThatThrownBy(() -> new StateInformation().x(1.0).in(ReferenceFrame.utm(4, true)))
        .hasMessage(
            "StateInformation cannot be converted from GLOBAL to UTM 4N: x and y are needed");
    assertThatThrownBy(
            () ->
                NavigationPoint.at(Point.ORIGIN).in(ReferenceFrame.GLOBAL, new StateInformation()))
        .hasMessageStartingWith(
            "NavigationPoint cannot be converted from BODY to GLOBAL: the vehicle's state lacks");
    assertThatThrownBy(
            () -> NavigationPoint.at(Point.ORIGIN).in(ReferenceFrame.LOCAL_NED, at(HONOLULU)))
        .hasMessageContaining("from BODY to LOCAL_NED by a vehicle's state in GLOBAL");
  }

  @Test
  void in_objectSeenByVehicle_shapeMovesWhole() {
    StateInformation vehicle =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(100.0)
            .y(200.0)
            .z(0.0)
            .psi(Math.PI / 2.0); // ENU: to the north
    Rectangle seen = new Rectangle().uid("r").referenceFrame(ReferenceFrame.BODY_FLU).x(10).y(2);
    seen.length(4.0).width(1.0).psi(0.0);

    Rectangle placed = (Rectangle) seen.in(ReferenceFrame.LOCAL_ENU, vehicle);

    assertThat(placed.center().distanceTo(Point.of(98.0, 210.0, 0.0))).isLessThan(1e-9);
    assertThat(placed.psi()).isCloseTo(Math.PI / 2.0, EXACT);
    assertThat(placed.distanceTo(Point.of(98.0, 213.0, 0.0))).isCloseTo(1.0, within(1e-9));
    PointCloud cloud = new PointCloud().uid("c").referenceFrame(ReferenceFrame.BODY_FLU).x(1).y(0);
    cloud.points(List.of(Point.of(1.0, 0.0, 0.0)));
    PointCloud moved = (PointCloud) cloud.in(ReferenceFrame.LOCAL_ENU, vehicle);
    assertThat(moved.points().get(0).distanceTo(Point.of(100.0, 201.0, 0.0))).isLessThan(1e-9);
  }

  private static StateInformation at(Geodetic place) {
    return new StateInformation()
        .x(place.longitudeDeg())
        .y(place.latitudeDeg())
        .z(place.altitudeM());
  }

  @Test
  void in_bodyFrames_ratesAndForcesOfAnInertialMeasurementTurnToo() {
    InertialMeasurement frd =
        new InertialMeasurement()
            .rollRate(0.1)
            .pitchRate(0.2)
            .yawRate(0.3)
            .specificForceX(1.0)
            .specificForceY(2.0)
            .specificForceZ(-9.8);

    InertialMeasurement flu = (InertialMeasurement) frd.in(ReferenceFrame.BODY_FLU);
    InertialMeasurement body = (InertialMeasurement) flu.in(ReferenceFrame.BODY);

    assertThat(flu.rollRate()).hasValue(0.1);
    assertThat(flu.pitchRate()).hasValue(-0.2);
    assertThat(flu.yawRate()).hasValue(-0.3);
    assertThat(flu.specificForceX()).hasValue(1.0);
    assertThat(flu.specificForceY()).hasValue(-2.0);
    assertThat(flu.specificForceZ()).hasValue(9.8);
    assertThat(body.rollRate()).hasValue(-0.1);
    assertThat(body.pitchRate()).hasValue(0.2);
    assertThat(body.specificForceZ()).hasValue(-9.8);
    assertThat(body.in(ReferenceFrame.BODY_FRD)).isEqualTo(frd);
  }

  @Test
  void in_otherFrame_sightedLandmarkKeepsItsPlace() {
    LandmarkSighting ned = new LandmarkSighting().landmarkX(30.0).landmarkY(40.0).bearing(0.5);
    ned.referenceFrame(ReferenceFrame.LOCAL_NED);

    LandmarkSighting enu = ned.in(ReferenceFrame.LOCAL_ENU);
    LandmarkSighting global = enu.in(ReferenceFrame.GLOBAL, HONOLULU);

    assertThat(enu.landmarkX()).hasValue(40.0);
    assertThat(enu.landmarkY()).hasValue(30.0);
    assertThat(global.bearing()).hasValue(0.5);
    Geodetic place =
        new Geodetic(
            global.landmarkX().orElseThrow(),
            global.landmarkY().orElseThrow(),
            HONOLULU.altitudeM());
    assertThat(HONOLULU.nedOf(place).x()).isCloseTo(30.0, within(1e-3));
    assertThat(HONOLULU.nedOf(place).y()).isCloseTo(40.0, within(1e-3));
  }
}
