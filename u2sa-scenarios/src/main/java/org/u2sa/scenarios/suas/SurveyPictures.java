package org.u2sa.scenarios.suas;

import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.sim.device.SimulatedDevice;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;

/** The simulated camera under the aircraft, looking straight down at the field. */
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

  private final Optics optics;
  private final RunningVehicle vehicle;
  private final FieldPainter painter;
  private final Consumer<VehicleTruth> exposed;

  /**
   * @param exposed called with the truth of each image
   */
  SurveyPictures(
      Optics optics, RunningVehicle vehicle, FieldPainter painter, Consumer<VehicleTruth> exposed) {
    super(optics.rateHz(), 0.0);
    this.optics = optics;
    this.vehicle = vehicle;
    this.painter = painter;
    this.exposed = exposed;
  }

  @Override
  protected CameraFrame measure(double timeS, long measuredAtMicros) {
    VehicleTruth truth = vehicle.at(measuredAtMicros);
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
