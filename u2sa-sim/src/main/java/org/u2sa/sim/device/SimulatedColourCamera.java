package org.u2sa.sim.device;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Renderer;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A camera with rendered RGB24 images. */
public final class SimulatedColourCamera extends SimulatedDevice<CameraFrame> implements Camera {
  private final ColourLens lens;
  private final Renderer renderer;
  private final Supplier<VehicleTruth> truth;

  /**
   * Uses the random stream {@code camera}.
   *
   * @param truth current state of the camera's vehicle
   */
  public SimulatedColourCamera(
      ColourLens lens, Scenery scenery, NoiseStreams streams, Supplier<VehicleTruth> truth) {
    super(lens.rateHz(), 0.0);
    this.lens = lens;
    this.truth = truth;
    renderer = new Renderer(lens, scenery, streams);
  }

  @Override
  protected CameraFrame measure(double timeS, long measuredAtMicros) {
    return new CameraFrame(
        measuredAtMicros,
        lens.width(),
        lens.height(),
        CameraFrame.PixelFormat.RGB24,
        renderer.picture(truth.get()),
        Optional.of(lens.intrinsics()));
  }
}
