package org.u2sa.sim.device;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Renderer;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.camera.ThermalRenderer;
import org.u2sa.sim.camera.WaterRenderer;
import org.u2sa.sim.camera.WaterScenery;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A camera with rendered images: RGB24, or GREY8 of a thermal camera. */
public final class SimulatedColourCamera extends SimulatedDevice<CameraFrame> implements Camera {
  private final ColourLens lens;
  private final PixelFormat format;
  private final Function<VehicleTruth, byte[]> renderer;
  private final Supplier<VehicleTruth> truth;

  /**
   * A camera on land. Uses the random stream {@code camera}.
   *
   * @param truth current state of the camera's vehicle
   */
  public SimulatedColourCamera(
      ColourLens lens, Scenery scenery, NoiseStreams streams, Supplier<VehicleTruth> truth) {
    this(lens, PixelFormat.RGB24, new Renderer(lens, scenery, streams)::picture, truth);
  }

  /** A camera above or under water. Uses the random streams {@code camera}, {@code particles}. */
  public SimulatedColourCamera(
      ColourLens lens, WaterScenery scenery, NoiseStreams streams, Supplier<VehicleTruth> truth) {
    this(lens, PixelFormat.RGB24, new WaterRenderer(lens, scenery, streams)::picture, truth);
  }

  public SimulatedColourCamera(
      ColourLens lens, ThermalRenderer renderer, Supplier<VehicleTruth> truth) {
    this(lens, PixelFormat.GREY8, renderer::picture, truth);
  }

  private SimulatedColourCamera(
      ColourLens lens,
      PixelFormat format,
      Function<VehicleTruth, byte[]> renderer,
      Supplier<VehicleTruth> truth) {
    super(lens.rateHz(), 0.0);
    this.lens = lens;
    this.format = format;
    this.renderer = renderer;
    this.truth = truth;
  }

  @Override
  protected CameraFrame measure(double timeS, long measuredAtMicros) {
    return new CameraFrame(
        measuredAtMicros,
        lens.width(),
        lens.height(),
        format,
        renderer.apply(truth.get()),
        Optional.of(lens.intrinsics()));
  }
}
