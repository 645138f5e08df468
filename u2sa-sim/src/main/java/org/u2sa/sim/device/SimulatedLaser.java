package org.u2sa.sim.device;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import org.u2sa.device.LaserScanner;
import org.u2sa.messages.RangeScan;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/** A scanning laser whose beams all go out at one moment. */
public final class SimulatedLaser extends SimulatedDevice<LaserScanner.Scan>
    implements LaserScanner {
  private final Optics optics;
  private final Supplier<DoubleUnaryOperator> view;
  private final Random noise;

  /**
   * What it sees.
   *
   * @param rateHz scans a second
   * @param firstRad direction of the first beam, to the left positive [rad]
   * @param stepRad from each beam to the next [rad]
   * @param beams of a scan
   * @param nearestM least distance [m]
   * @param farthestM reach [m]
   * @param sigmaM standard deviation of a distance [m]
   */
  public record Optics(
      double rateHz,
      double firstRad,
      double stepRad,
      int beams,
      double nearestM,
      double farthestM,
      double sigmaM) {
    /** Hokuyo UST-10LX by its data sheet: 270° in steps of 0.25°, 40 Hz, 0.06…10 m, σ 30 mm. */
    public static Optics ust10lx() {
      double stepRad = Math.toRadians(0.25);
      return new Optics(40.0, -540 * stepRad, stepRad, 1081, 0.06, 10.0, 0.03);
    }
  }

  /**
   * Takes the stream {@code laser}.
   *
   * @param view what it sees from where it is now: the distance to the nearest thing in a
   *     direction, to the left positive [rad]; infinite if there is none [m]
   */
  public SimulatedLaser(Optics optics, NoiseStreams streams, Supplier<DoubleUnaryOperator> view) {
    super(optics.rateHz(), 0.0);
    Arguments.requireInside("beams", optics.beams(), 1.0, 100_000.0);
    this.optics = optics;
    this.view = view;
    noise = streams.of("laser");
  }

  @Override
  Scan measure(double timeS, long measuredAtMicros) {
    DoubleUnaryOperator distance = view.get();
    List<OptionalDouble> ranges = new ArrayList<>(optics.beams());
    for (int i = 0; i < optics.beams(); i++) {
      double trueM = distance.applyAsDouble(optics.firstRad() + i * optics.stepRad());
      double rangeM = trueM + optics.sigmaM() * noise.nextGaussian();
      boolean isEcho = rangeM >= optics.nearestM() && rangeM <= optics.farthestM();
      ranges.add(isEcho ? OptionalDouble.of(rangeM) : OptionalDouble.empty());
    }
    RangeScan scan =
        new RangeScan()
            .minRange(optics.nearestM())
            .maxRange(optics.farthestM())
            .beams(optics.firstRad(), optics.stepRad(), ranges);
    scan.timestamp(measuredAtMicros);
    return new Scan(measuredAtMicros, scan);
  }
}
