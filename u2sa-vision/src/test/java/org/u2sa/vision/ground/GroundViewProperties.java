package org.u2sa.vision.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.lens.LensCalibration.Spot;

class GroundViewProperties {
  private static final LensCalibration LENS =
      new LensCalibration(
          640,
          480,
          new Intrinsics(400.0, 402.0, 321.0, 238.0),
          -0.1,
          0.02,
          0.001,
          -0.001,
          0.0,
          0.2,
          9);

  private static GroundView view(double yaw, double roll, double pitch) {
    return new GroundView(
        LENS, CameraMount.of(new MountingPose(0.3, 0.1, -1.0, 0.02, -0.35, yaw), 0.2), roll, pitch);
  }

  @Property(tries = 300)
  void ground_ofThePixelOfAPlace_isThatPlace(
      @ForAll @DoubleRange(min = 1.6, max = 9.0) double forward,
      @ForAll @DoubleRange(min = -0.9, max = 0.9) double right,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double roll,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double pitch,
      @ForAll @DoubleRange(min = -0.2, max = 0.2) double yaw) {
    GroundView view = view(yaw, roll, pitch);
    Point place = view.onGround(forward, right);
    Spot pixel = view.pixel(place).orElseThrow();
    Point back = view.ground(pixel.x(), pixel.y()).orElseThrow();
    assertThat(back.distanceTo(place)).isLessThan(1e-6);
    assertThat(view.toLevel(view.toBody(place)).distanceTo(place)).isLessThan(1e-9);
  }

  @Property(tries = 200)
  void pixel_vehicleTilted_isWhereTheTiltedBodySeesIt(
      @ForAll @DoubleRange(min = 1.6, max = 9.0) double forward,
      @ForAll @DoubleRange(min = -0.9, max = 0.9) double right,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double roll,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double pitch) {
    // A place in BODY is seen at one pixel, however the vehicle stands.
    GroundView tilted = view(0.0, roll, pitch);
    GroundView flat = view(0.0, 0.0, 0.0);
    Point body = tilted.toBody(tilted.onGround(forward, right));
    Spot one = tilted.pixel(tilted.toLevel(body)).orElseThrow();
    Spot other = flat.pixel(flat.toLevel(body)).orElseThrow();
    assertThat(one.x()).isCloseTo(other.x(), within(1e-6));
    assertThat(one.y()).isCloseTo(other.y(), within(1e-6));
  }

  @Example
  void pixel_placeToTheRight_isInTheRightHalf() {
    GroundView view = view(0.0, 0.0, 0.0);
    assertThat(view.pixel(view.onGround(4.0, 1.0)).orElseThrow().x()).isGreaterThan(330.0);
    assertThat(view.toBody(view.onGround(4.0, 1.0)).y()).isEqualTo(-1.0);
  }

  @Example
  void pixel_frontUpOrYawLeft_movesDownOrRight() {
    Point place = view(0.0, 0.0, 0.0).onGround(4.0, 0.0);
    Spot straight = view(0.0, 0.0, 0.0).pixel(place).orElseThrow();
    assertThat(view(0.0, 0.0, 0.05).pixel(place).orElseThrow().y()).isGreaterThan(straight.y());
    assertThat(view(0.1, 0.0, 0.0).pixel(place).orElseThrow().x()).isGreaterThan(straight.x());
  }

  @Example
  void ground_aboveTheHorizon_isEmpty() {
    assertThat(view(0.0, 0.0, 0.0).ground(320.0, 10.0)).isEmpty();
  }

  @Property(tries = 100)
  void alongM_tiltError_isWhatATiltDoes(
      @ForAll @DoubleRange(min = 1.0, max = 10.0) double range,
      @ForAll @DoubleRange(min = 0.5, max = 2.0) double height) {
    double tilt = 1e-4;
    double angle = Math.atan2(height, range);
    double moved = height / Math.tan(angle - tilt) - range;
    GroundSigma sigma = new GroundSigma(0.0, tilt, 0.0, 0.0, 0.0);
    assertThat(sigma.alongM(range, height)).isCloseTo(moved, within(0.01 * moved));
    assertThat(sigma.acrossM(range)).isZero();
    assertThat(new GroundSigma(tilt, 0.0, 0.0, 0.0, 0.0).acrossM(range))
        .isCloseTo(tilt * range, within(1e-12));
  }
}
