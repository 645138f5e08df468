package org.u2sa.device.payload;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.messages.frame.Point;

/** Directions by arrival times at random arrays, against the direction the times were made from. */
class ArrivalDirectionProperties {
  private static final double SOUND_MPS = 1_480.0;
  private static final double SIGMA_S = 2e-6;
  private static final List<Point> SQUARE =
      List.of(
          Point.of(0.1, 0.1, 0.0),
          Point.of(0.1, -0.1, 0.0),
          Point.of(-0.1, 0.1, 0.0),
          Point.of(-0.1, -0.1, 0.0));

  private static Point direction(double azimuth, double elevation) {
    double level = Math.cos(elevation);
    return Point.of(level * Math.cos(azimuth), level * Math.sin(azimuth), -Math.sin(elevation));
  }

  /** A corner of a cube of 0.2 m and its three neighbours, each moved a little. */
  private static List<Point> corner(Random random) {
    List<Point> places = new ArrayList<>();
    for (double[] at : new double[][] {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      places.add(
          Point.of(
              0.2 * at[0] + 0.04 * random.nextDouble(),
              0.2 * at[1] + 0.04 * random.nextDouble(),
              0.2 * at[2] + 0.04 * random.nextDouble()));
    }
    return places;
  }

  /** Arrival times of a plane wave, with noise. */
  private static List<Double> times(List<Point> places, Point from, double sigmaS, Random random) {
    List<Double> times = new ArrayList<>();
    double startS = 3.0 * random.nextDouble();
    for (Point place : places) {
      double nearerM = place.x() * from.x() + place.y() * from.y() + place.z() * from.z();
      times.add(startS - nearerM / SOUND_MPS + sigmaS * random.nextGaussian());
    }
    return times;
  }

  @Property
  void of_exactTimesAtAnySpatialArray_isTheDirection(
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double azimuth,
      @ForAll @DoubleRange(min = -1.57, max = 1.57) double elevation,
      @ForAll long seed) {
    Random random = new Random(seed);
    List<Point> places = corner(random);
    Point truth = direction(azimuth, elevation);

    ArrivalDirection found =
        ArrivalDirection.of(places, times(places, truth, 0.0, random), SOUND_MPS, SIGMA_S);

    assertThat(found.direction().distanceTo(truth)).isLessThan(1e-6);
    assertThat(found.residualS()).isLessThan(1e-9);
  }

  @Property
  void of_noisyTimes_errorIsWithinFiveOfItsSigmas(
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double azimuth,
      @ForAll @DoubleRange(min = -1.57, max = 1.57) double elevation,
      @ForAll long seed) {
    Random random = new Random(seed);
    List<Point> places = corner(random);
    Point truth = direction(azimuth, elevation);

    ArrivalDirection found =
        ArrivalDirection.of(places, times(places, truth, SIGMA_S, random), SOUND_MPS, SIGMA_S);

    assertThat(found.direction().distanceTo(truth)).isLessThan(5.0 * found.sigmaRad());
    assertThat(Math.toDegrees(found.sigmaRad())).isBetween(0.3, 3.0);
  }

  @Property
  void of_levelSquareAndSourceBelow_isTheDirectionBelow(
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double azimuth,
      @ForAll @DoubleRange(min = 0.1, max = 1.5) double depression,
      @ForAll long seed) {
    Point truth = direction(azimuth, -depression);

    ArrivalDirection found =
        ArrivalDirection.of(
            SQUARE, times(SQUARE, truth, 0.0, new Random(seed)), SOUND_MPS, SIGMA_S);

    assertThat(found.direction().distanceTo(truth)).isLessThan(1e-4);
  }

  @Property
  void of_oneHydrophoneHearsAnEcho_residualTellsIt(
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double azimuth, @ForAll long seed) {
    Random random = new Random(seed);
    List<Point> places = corner(random);
    List<Double> times = times(places, direction(azimuth, -0.3), SIGMA_S, random);
    times.set(2, times.get(2) + 5e-4);

    ArrivalDirection found = ArrivalDirection.of(places, times, SOUND_MPS, SIGMA_S);

    assertThat(found.residualS()).isGreaterThan(10.0 * SIGMA_S);
  }
}
