package org.u2sa.sim.device;

import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.World;

/** A greyscale pinhole camera with pixel noise. */
public final class SimulatedCamera extends SimulatedDevice<CameraFrame> implements Camera {
  private static final double WHITE = 255.0;
  private static final double SKY = 0.9;
  private static final double GROUND = 0.5;
  private static final double OBSTACLE = 0.1;

  private final Lens lens;
  private final Intrinsics intrinsics;
  private final Supplier<Scene> scene;
  private final Random noise;

  /** The scene in front of a camera at one moment. */
  @FunctionalInterface
  public interface Scene {
    /**
     * Brightness in a direction, 0 black … 1 white.
     *
     * @param direction unit vector in camera axes: x ahead, y right, z down
     */
    double brightness(Point direction);
  }

  /**
   * Camera parameters.
   *
   * @param rateHz frames per second
   * @param width image width [px]
   * @param height image height [px]
   * @param viewRad horizontal field of view [rad]
   * @param sigma standard deviation of a pixel's brightness, relative to white
   */
  public record Lens(double rateHz, int width, int height, double viewRad, double sigma) {
    /**
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Lens {
      Arguments.requireInside("width", width, 1.0, 10_000.0);
      Arguments.requireInside("height", height, 1.0, 10_000.0);
      Arguments.requireInside("angle of view", viewRad, 0.01, 3.0);
      Arguments.requireInside("noise of a pixel", sigma, 0.0, 1.0);
    }

    /** Intrinsics with square pixels and a centred principal point. */
    Intrinsics intrinsics() {
      double focal = 0.5 * width / StrictMath.tan(0.5 * viewRad);
      return new Intrinsics(focal, focal, 0.5 * (width - 1), 0.5 * (height - 1));
    }
  }

  /**
   * Uses the random stream {@code camera}.
   *
   * @param scene supplies the current scene
   */
  public SimulatedCamera(Lens lens, NoiseStreams streams, Supplier<Scene> scene) {
    super(lens.rateHz(), 0.0);
    this.lens = lens;
    intrinsics = lens.intrinsics();
    this.scene = scene;
    noise = streams.of("camera");
  }

  /**
   * Scene straight ahead of a vehicle's reference point: bright sky, grey ground, dark obstacles.
   *
   * @param rangeM visibility range; only sky beyond it [m]
   */
  public static Scene ahead(World world, VehicleTruth truth, double rangeM) {
    World seen = world.when(truth.timeS());
    return direction -> {
      Point ned = truth.attitude().nedFromFrd().times(direction);
      double length = ned.distance();
      Ray ray =
          new Ray(
              truth.position().x(),
              truth.position().y(),
              truth.position().z(),
              ned.y() / length,
              ned.x() / length,
              -ned.z() / length);
      Optional<World.Hit> hit = seen.cast(ray, rangeM);
      double even = hit.map(at -> at.object().isPresent() ? OBSTACLE : GROUND).orElse(SKY);
      return seen.light().map(sun -> sun.lit(even, ray, hit, seen, rangeM)).orElse(even);
    };
  }

  @Override
  protected CameraFrame measure(double timeS, long measuredAtMicros) {
    Scene now = scene.get();
    byte[] pixels = new byte[lens.width() * lens.height()];
    for (int row = 0; row < lens.height(); row++) {
      double down = (row - intrinsics.centreY()) / intrinsics.focalY();
      for (int column = 0; column < lens.width(); column++) {
        double right = (column - intrinsics.centreX()) / intrinsics.focalX();
        double length = StrictMath.sqrt(1.0 + right * right + down * down);
        double bright = now.brightness(Point.of(1.0 / length, right / length, down / length));
        double noisy = bright + lens.sigma() * noise.nextGaussian();
        pixels[row * lens.width() + column] =
            (byte) Math.round(WHITE * Math.max(0.0, Math.min(1.0, noisy)));
      }
    }
    return new CameraFrame(
        measuredAtMicros,
        lens.width(),
        lens.height(),
        CameraFrame.PixelFormat.GREY8,
        pixels,
        Optional.of(intrinsics));
  }
}
