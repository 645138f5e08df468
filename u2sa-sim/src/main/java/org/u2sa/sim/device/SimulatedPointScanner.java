package org.u2sa.sim.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.u2sa.device.port.PointScanner;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/** A 3-D lidar, or a depth camera, whose points of one scan are simultaneous. */
public final class SimulatedPointScanner extends SimulatedDevice<PointScanner.Cloud>
    implements PointScanner {
  private static final int MAX_DIRECTIONS = 500_000;

  private final Optics optics;
  private final List<Point> directions = new ArrayList<>(); // unit vectors ahead, left, down
  private final Supplier<ToDoubleFunction<Point>> view;
  private final Random noise;

  /**
   * Scan parameters.
   *
   * @param rateHz scans per second
   * @param widthRad horizontal angle covered, symmetric about straight ahead [rad]
   * @param columns number of directions over that angle
   * @param heightRad vertical angle covered, symmetric about the level [rad]
   * @param rows number of directions over that angle
   * @param nearestM minimum range [m]
   * @param farthestM maximum range [m]
   * @param sigmaM standard deviation of a range [m]
   */
  public record Optics(
      double rateHz,
      double widthRad,
      int columns,
      double heightRad,
      int rows,
      double nearestM,
      double farthestM,
      double sigmaM) {}

  /**
   * Uses the random stream {@code point scanner}.
   *
   * @param view range from the current pose along a unit vector ahead, left and down [m]; infinite
   *     without an echo
   */
  public SimulatedPointScanner(
      Optics optics, NoiseStreams streams, Supplier<ToDoubleFunction<Point>> view) {
    super(optics.rateHz(), 0.0);
    Arguments.requireInside(
        "directions of a scan", (double) optics.columns() * optics.rows(), 1.0, MAX_DIRECTIONS);
    this.optics = optics;
    this.view = view;
    noise = streams.of("point scanner");
    for (int row = 0; row < optics.rows(); row++) {
      double up = angle(optics.heightRad(), row, optics.rows());
      for (int column = 0; column < optics.columns(); column++) {
        double left = angle(optics.widthRad(), column, optics.columns());
        directions.add(
            Point.of(
                StrictMath.cos(up) * StrictMath.cos(left),
                StrictMath.cos(up) * StrictMath.sin(left),
                -StrictMath.sin(up)));
      }
    }
  }

  /** Centre angle of one of several equal sectors. */
  private static double angle(double wholeRad, int part, int parts) {
    return wholeRad * ((part + 0.5) / parts - 0.5);
  }

  @Override
  protected Cloud measure(double timeS, long measuredAtMicros) {
    ToDoubleFunction<Point> sight = view.get();
    List<Point> points = new ArrayList<>();
    for (Point direction : directions) {
      double rangeM = sight.applyAsDouble(direction) + optics.sigmaM() * noise.nextGaussian();
      if (rangeM >= optics.nearestM() && rangeM <= optics.farthestM()) {
        points.add(
            Point.of(rangeM * direction.x(), rangeM * direction.y(), rangeM * direction.z()));
      }
    }
    return new Cloud(measuredAtMicros, List.copyOf(points));
  }
}
