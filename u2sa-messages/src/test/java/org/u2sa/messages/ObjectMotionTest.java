package org.u2sa.messages;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.MovingSphere;

/** Velocity and uncertainty of objects: over time, and from frame to frame. */
class ObjectMotionTest {
  private static ObjectDescription object(ReferenceFrame frame, double x, double y) {
    return new ObjectDescription().uid("o").referenceFrame(frame).x(x).y(y);
  }

  private static void assertPoint(Point actual, double x, double y, double z) {
    assertThat(actual.distanceTo(Point.of(x, y, z))).as(actual.toString()).isLessThan(1e-6);
  }

  @Test
  void velocity_notSet_isUnknown() {
    ObjectDescription object = object(ReferenceFrame.LOCAL_NED, 1.0, 2.0);
    assertThat(object.motion().velocity()).isEmpty();
    assertThat(object.motion().sigma()).isEmpty();
    assertThat(object.confidence()).isEmpty();
    assertThat(object.sensorName()).isEmpty();
    assertThat(object.after(10.0).center()).isEqualTo(object.center());
    assertThatThrownBy(() -> object.confidence(1.5)).hasMessageContaining("confidence");
  }

  @Test
  void after_someSeconds_movesCentrePointsAndUncertainty() {
    Line line = new Line().points(List.of(Point.of(0, 0, 0), Point.of(1, 1, 0)));
    line.uid("l").referenceFrame(ReferenceFrame.LOCAL_NED).x(0.5).y(0.5);
    line.motion()
        .velocity(Point.of(1.0, -2.0, 0.0))
        .sigma(Point.of(3.0, 3.0, 0.0))
        .velocitySigma(2.0);
    line.timestamp(1_000_000L);

    Line later = (Line) line.after(2.0);

    assertPoint(later.center(), 2.5, -3.5, 0.0);
    assertPoint(later.points().get(1), 3.0, -3.0, 0.0);
    assertPoint(later.motion().sigma().orElseThrow(), 5.0, 5.0, 4.0);
    assertThat(later.timestamp()).hasValue(3_000_000L);
  }

  @Test
  void in_bodyToLocal_turnsVelocityWithTheVehicle() {
    StateInformation east = new StateInformation().x(100.0).y(50.0).psi(Math.PI / 2.0);
    east.referenceFrame(ReferenceFrame.LOCAL_NED);
    ObjectDescription ahead = object(ReferenceFrame.BODY, 10.0, 2.0);
    ahead.motion().velocity(Point.of(3.0, 1.0, 0.0)); // forward and to the left

    ObjectDescription placed = ahead.in(ReferenceFrame.LOCAL_NED, east);

    assertPoint(placed.center(), 102.0, 60.0, 0.0);
    assertPoint(placed.motion().velocity().orElseThrow(), 1.0, 3.0, 0.0); // left of east is north
    assertThat(placed.motion().sigma()).isEmpty();
  }

  @Test
  void in_globalToUtm_velocityTurnsByTheGridsConvergenceOnly() {
    ObjectDescription ship =
        object(ReferenceFrame.GLOBAL, -157.0, 21.3); // 2° off zone 4's meridian
    ship.motion().velocity(Point.of(0.0, 10.0, 0.0));

    Point turned = ship.in(ReferenceFrame.utm(4, true), null).motion().velocity().orElseThrow();

    assertThat(turned.distance()).isCloseTo(10.0, within(1e-6));
    // convergence ≈ (λ - λ0)·sin φ (Snyder, Map Projections, 1987, eq. 8-20, first order)
    assertThat(Math.atan2(turned.x(), turned.y()))
        .isCloseTo(-Math.toRadians(2.0) * Math.sin(Math.toRadians(21.3)), within(1e-4));
  }

  @Test
  void in_bodyToLocal_sigmaIsThatOfManyDraws() {
    StateInformation mean = new StateInformation().x(5.0).y(-3.0).z(1.0);
    mean.phi(0.1).theta(-0.15).psi(0.7).referenceFrame(ReferenceFrame.LOCAL_NED);
    mean.xSigma(0.2).ySigma(0.4).zSigma(0.1).phiSigma(0.01).thetaSigma(0.02).psiSigma(0.03);
    ObjectDescription seen = object(ReferenceFrame.BODY, 20.0, 6.0).z(1.0);
    seen.motion().sigma(Point.of(0.5, 0.1, 0.2));
    Point stated = seen.in(ReferenceFrame.LOCAL_NED, mean).motion().sigma().orElseThrow();

    Random random = new Random(7L);
    int draws = 20_000;
    double[] sum = new double[3];
    double[] squares = new double[3];
    for (int i = 0; i < draws; i++) {
      StateInformation drawn = mean.copy();
      drawn.x(5.0 + 0.2 * random.nextGaussian()).y(-3.0 + 0.4 * random.nextGaussian());
      drawn.z(1.0 + 0.1 * random.nextGaussian()).phi(0.1 + 0.01 * random.nextGaussian());
      drawn.theta(-0.15 + 0.02 * random.nextGaussian()).psi(0.7 + 0.03 * random.nextGaussian());
      Point at =
          object(
                  ReferenceFrame.BODY,
                  20.0 + 0.5 * random.nextGaussian(),
                  6.0 + 0.1 * random.nextGaussian())
              .z(1.0 + 0.2 * random.nextGaussian())
              .in(ReferenceFrame.LOCAL_NED, drawn)
              .center();
      double[] values = {at.x(), at.y(), at.z()};
      for (int k = 0; k < 3; k++) {
        sum[k] += values[k];
        squares[k] += values[k] * values[k];
      }
    }

    double[] expected = {stated.x(), stated.y(), stated.z()};
    for (int k = 0; k < 3; k++) {
      double drawnSigma = Math.sqrt(squares[k] / draws - sum[k] / draws * (sum[k] / draws));
      assertThat(drawnSigma / expected[k]).isCloseTo(1.0, within(0.04));
    }
  }

  @Test
  void in_localToBody_addsTheVehiclesUncertaintyToo() {
    StateInformation vehicle = new StateInformation().x(0.0).y(0.0).psi(0.0).psiSigma(0.1);
    vehicle.referenceFrame(ReferenceFrame.LOCAL_NED).xSigma(3.0).ySigma(0.0);
    ObjectDescription mast = object(ReferenceFrame.LOCAL_NED, 40.0, 0.0);
    mast.motion().sigma(Point.of(4.0, 3.0, 0.0));

    Point sigma = mast.in(ReferenceFrame.BODY, vehicle).motion().sigma().orElseThrow();

    assertPoint(sigma, 5.0, 5.0, 0.0); // sideways: 3 m, and 0.1 rad over 40 m
  }

  @Test
  void centerAfter_noTrajectory_goesOnWithTheVelocity() {
    MovingSphere traffic = new MovingSphere().radius(10.0);
    traffic.uid("N123").referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0);
    traffic.motion().velocity(Point.of(20.0, 0.0, -1.0));

    assertPoint(traffic.centerAfter(5.0), 100.0, 0.0, -5.0);
  }
}
