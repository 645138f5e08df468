package org.u2sa.vision.lens;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.vision.lens.LensCalibration.Spot;

class LensCalibrationProperties {
  private static final Intrinsics PINHOLE = new Intrinsics(536.0, 534.0, 342.0, 235.0);

  private static LensCalibration lens(double k1, double k2, double p1, double p2) {
    return new LensCalibration(640, 480, PINHOLE, k1, k2, p1, p2, 0.0, 0.2, 12);
  }

  @Property(tries = 300)
  void place_ofAPixelOfAPlace_isThatPlace(
      @ForAll @Scale(6) @DoubleRange(min = -0.6, max = 0.6) double x,
      @ForAll @Scale(6) @DoubleRange(min = -0.45, max = 0.45) double y,
      @ForAll @Scale(6) @DoubleRange(min = -0.3, max = 0.3) double k1,
      @ForAll @Scale(6) @DoubleRange(min = 0.0, max = 0.1) double k2,
      @ForAll @Scale(6) @DoubleRange(min = -0.003, max = 0.003) double p1,
      @ForAll @Scale(6) @DoubleRange(min = -0.003, max = 0.003) double p2) {
    LensCalibration lens = lens(k1, k2, p1, p2);
    Spot pixel = lens.pixel(x, y);
    Optional<Spot> back = lens.place(pixel.x(), pixel.y());
    assertThat(back).isPresent();
    assertThat(back.get().x()).isCloseTo(x, within(1e-9));
    assertThat(back.get().y()).isCloseTo(y, within(1e-9));
  }

  @Property(tries = 100)
  void pixel_barrelDistortion_isNearerToTheAxis(
      @ForAll @Scale(6) @DoubleRange(min = 0.1, max = 0.6) double x,
      @ForAll @Scale(6) @DoubleRange(min = -0.4, max = -0.1) double k1) {
    assertThat(lens(k1, 0.0, 0.0, 0.0).pixel(x, 0.0).x()).isLessThan(PINHOLE.focalX() * x + 342.0);
    assertThat(lens(k1, 0.0, 0.0, 0.0).pixel(x, 0.0).y()).isCloseTo(235.0, within(1e-9));
  }

  @Property(tries = 100)
  void scaledTo_halfTheSize_seesTheSamePlaceAtHalfThePixel(
      @ForAll @Scale(6) @DoubleRange(min = -0.5, max = 0.5) double x,
      @ForAll @Scale(6) @DoubleRange(min = -0.4, max = 0.4) double y) {
    LensCalibration whole = lens(-0.2, 0.05, 0.001, -0.001);
    Spot large = whole.pixel(x, y);
    Spot small = whole.scaledTo(320, 240).pixel(x, y);
    assertThat(small.x() + 0.5).isCloseTo(0.5 * (large.x() + 0.5), within(1e-9));
    assertThat(small.y() + 0.5).isCloseTo(0.5 * (large.y() + 0.5), within(1e-9));
  }
}
