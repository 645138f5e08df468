package org.u2sa.sim.device;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Supplier;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.messages.RangeScan;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/** A lidar whose beams of one scan are simultaneous. */
public final class SimulatedLaser extends SimulatedDevice<LaserScanner.Scan>
    implements LaserScanner {
  private static final double EDGE_M =
      0.2; // range step between neighbouring beams that counts as an edge

  private final Optics optics;
  private final double[] cosines; // cosines of the beam directions, fixed for all scans
  private final double[] sines;
  private final Supplier<Sight> view;
  private final Random noise;
  private final Faults faults;
  private final Random faulty;

  /**
   * Scan parameters.
   *
   * @param rateHz scans per second
   * @param firstRad direction of the first beam, left positive [rad]
   * @param stepRad angle between beams [rad]
   * @param beams beams per scan
   * @param nearestM minimum range [m]
   * @param farthestM maximum range [m]
   * @param sigmaM standard deviation of a range [m]
   */
  public record Optics(
      double rateHz,
      double firstRad,
      double stepRad,
      int beams,
      double nearestM,
      double farthestM,
      double sigmaM) {
    /** Hokuyo UST-10LX, data sheet: 270° at 0.25°, 40 Hz, 0.06…10 m, σ 30 mm. */
    public static Optics ust10lx() {
      double stepRad = Math.toRadians(0.25);
      return new Optics(40.0, -540 * stepRad, stepRad, 1081, 0.06, 10.0, 0.03);
    }
  }

  /** Range measurements of the surroundings at one instant. */
  @FunctionalInterface
  public interface Sight {
    /**
     * Range to the nearest object in a direction [m]; infinite if there is none.
     *
     * @param angleRad left positive [rad]
     * @param cos of that angle
     * @param sin of that angle
     */
    double distanceM(double angleRad, double cos, double sin);
  }

  /**
   * Faults of single beams.
   *
   * @param dropOut fraction of lost echoes, 0…1, e.g. from dark or smooth surfaces
   * @param mixed fraction of beams at an edge that hit both foreground and background, 0…1, and
   *     measure a range in between (mixed pixels) (Tuley, Vandapel, Hebert: Analysis and Removal of
   *     Artifacts in 3-D LADAR Data, ICRA 2005)
   */
  public record Faults(double dropOut, double mixed) {
    /** None. */
    public static final Faults NONE = new Faults(0.0, 0.0);

    /**
     * @throws IllegalArgumentException if a share is outside 0…1
     */
    public Faults {
      Arguments.requireInside("share of echoes that are lost", dropOut, 0.0, 1.0);
      Arguments.requireInside("share of mixed pixels at edges", mixed, 0.0, 1.0);
    }
  }

  /**
   * A lidar without faults; uses the random stream {@code laser}.
   *
   * @param view range measurements from the current pose
   */
  public SimulatedLaser(Optics optics, NoiseStreams streams, Supplier<Sight> view) {
    this(optics, Faults.NONE, streams, view);
  }

  /**
   * Uses the random streams {@code laser} and {@code laser faults}.
   *
   * @param view range measurements from the current pose
   */
  public SimulatedLaser(Optics optics, Faults faults, NoiseStreams streams, Supplier<Sight> view) {
    super(optics.rateHz(), 0.0);
    Arguments.requireInside("beams", optics.beams(), 1.0, 100_000.0);
    this.optics = optics;
    cosines = new double[optics.beams()];
    sines = new double[optics.beams()];
    for (int i = 0; i < optics.beams(); i++) {
      cosines[i] = Math.cos(angleRad(i));
      sines[i] = Math.sin(angleRad(i));
    }
    this.view = view;
    this.faults = faults;
    noise = streams.of("laser");
    faulty = streams.of("laser faults");
  }

  private double angleRad(int beam) {
    return optics.firstRad() + beam * optics.stepRad();
  }

  @Override
  protected Scan measure(double timeS, long measuredAtMicros) {
    Sight sight = view.get();
    double[] seen = new double[optics.beams()];
    for (int i = 0; i < seen.length; i++) {
      seen[i] = sight.distanceM(angleRad(i), cosines[i], sines[i]);
    }
    List<OptionalDouble> ranges = new ArrayList<>(optics.beams());
    for (int i = 0; i < optics.beams(); i++) {
      double rangeM = mixed(seen, i) + optics.sigmaM() * noise.nextGaussian();
      boolean isLost = faults.dropOut() > 0.0 && faulty.nextDouble() < faults.dropOut();
      boolean isEcho = !isLost && rangeM >= optics.nearestM() && rangeM <= optics.farthestM();
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

  /** Noise-free range of a beam; at an edge possibly a mixed range. */
  private double mixed(double[] seen, int beam) {
    double here = seen[beam];
    double next = seen[Math.min(beam + 1, seen.length - 1)];
    boolean isEdge = Math.abs(next - here) > EDGE_M && Math.max(here, next) <= optics.farthestM();
    if (faults.mixed() == 0.0 || !isEdge || faulty.nextDouble() >= faults.mixed()) {
      return here;
    }
    return here + faulty.nextDouble() * (next - here);
  }
}
