package org.u2sa.scenarios.suas;

import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.sim.device.SimulatedDevice;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.survey.CameraGimbal;

/**
 * The simulated camera under the aircraft, looking straight down at the field, fixed or on a gimbal
 * that follows the aircraft's rates with a lag.
 */
final class SurveyPictures extends SimulatedDevice<CameraFrame> implements Camera {
  /**
   * A lens without distortion.
   *
   * @param width pixels across the flight
   * @param height pixels along it
   * @param focalPx focal length [px]
   */
  record Optics(double rateHz, int width, int height, double focalPx) {
    Intrinsics intrinsics() {
      return new Intrinsics(focalPx, focalPx, 0.5 * (width - 1), 0.5 * (height - 1));
    }
  }

  /** The camera of the demo: 50 degrees across. */
  static final Optics USUAL = new Optics(2.0, 1280, 960, 1372.0);

  private static final double LAG_S = 0.05;

  private final Optics optics;
  private final RunningVehicle vehicle;
  private final Optional<CameraGimbal> gimbal;
  private final FieldPainter painter;
  private final Consumer<VehicleTruth> exposed;

  /**
   * @param gimbal empty: fixed to the aircraft
   * @param exposed called with the truth of each image, with the attitude of the camera's mount
   */
  SurveyPictures(
      Optics optics,
      RunningVehicle vehicle,
      Optional<CameraGimbal> gimbal,
      FieldPainter painter,
      Consumer<VehicleTruth> exposed) {
    super(optics.rateHz(), 0.0);
    this.optics = optics;
    this.vehicle = vehicle;
    this.gimbal = gimbal;
    this.painter = painter;
    this.exposed = exposed;
  }

  /** The truth with the attitude of the camera's mount. */
  static VehicleTruth levelled(CameraGimbal gimbal, VehicleTruth truth) {
    Attitude level = gimbal.of(truth.attitude());
    Attitude lagging =
        new Attitude(
            level.phi() + LAG_S * truth.rates().x(),
            level.theta() + LAG_S * truth.rates().y(),
            level.psi());
    return new VehicleTruth(
        truth.timeS(),
        truth.position(),
        lagging,
        truth.velocity(),
        truth.rates(),
        truth.acceleration());
  }

  @Override
  protected CameraFrame measure(double timeS, long measuredAtMicros) {
    VehicleTruth aircraft = vehicle.at(measuredAtMicros);
    VehicleTruth truth = gimbal.map(each -> levelled(each, aircraft)).orElse(aircraft);
    exposed.accept(truth);
    return new CameraFrame(
        measuredAtMicros,
        optics.width(),
        optics.height(),
        PixelFormat.RGB24,
        painter.picture(truth),
        Optional.of(optics.intrinsics()));
  }
}
