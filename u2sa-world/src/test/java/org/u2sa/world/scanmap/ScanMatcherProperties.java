package org.u2sa.world.scanmap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.LongRange;

/** A scan is found on a map of another one, and the claimed accuracy is that of the errors. */
class ScanMatcherProperties {
  private static final double REACH = 20.0;
  private static final double NOISE = 0.01;
  private static final double[] WEAK = Matrix3.inverse(Matrix3.ofSigmas(2.0, 2.0, 1.0));
  private static final Pose2 SEEN_FROM = new Pose2(3.0, 2.5, 0.3);

  private final ScanMatcher matcher = new ScanMatcher();

  private static LocalMap map(Room room, Random random) {
    LocalMap map = new LocalMap(REACH + 5.0);
    ScanPoints points = room.points(SEEN_FROM, REACH, NOISE, random);
    map.build(List.of(new KeyScan(SEEN_FROM, points, null, 0.0)), SEEN_FROM);
    return map;
  }

  @Property(tries = 60)
  void match_guessIsOff_findsThePose(
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double dx,
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double dy,
      @ForAll @DoubleRange(min = -0.2, max = 0.2) double turn,
      @ForAll @LongRange(min = 0, max = 1000) long seed) {
    Random random = new Random(seed);
    LocalMap map = map(Room.furnished(), random);
    Pose2 truth = new Pose2(3.4, 2.8, 0.6);
    ScanPoints scan = Room.furnished().points(truth, REACH, NOISE, random);
    Pose2 guess = new Pose2(truth.x() + dx, truth.y() + dy, truth.theta() + turn);

    ScanMatcher.Match match = matcher.match(map, scan, guess, WEAK, 0.7, 0.3);

    assertThat(match.pose().distance(truth)).isLessThan(0.04);
    assertThat(match.pose().theta()).isCloseTo(truth.theta(), within(0.01));
    assertThat(match.share()).isGreaterThan(0.8);
  }

  @Example
  void match_manyScans_errorsAreAsClaimed() {
    double sum = 0.0;
    int runs = 100;
    for (int seed = 0; seed < runs; seed++) {
      Random random = new Random(seed);
      LocalMap map = map(Room.furnished(), random);
      Pose2 truth =
          new Pose2(
              3.0 + 0.4 * random.nextGaussian(),
              2.5 + 0.4 * random.nextGaussian(),
              random.nextGaussian());
      ScanPoints scan = Room.furnished().points(truth, REACH, NOISE, random);
      ScanMatcher.Match match = matcher.match(map, scan, truth, WEAK, 0.3, 0.1);
      Pose2 pose = match.pose();
      sum +=
          Matrix3.square(
              match.information(),
              pose.x() - truth.x(),
              pose.y() - truth.y(),
              Pose2.wrapped(pose.theta() - truth.theta()));
    }
    assertThat(sum / runs / 3.0).as("squared error over the claimed variance").isBetween(0.02, 1.2);
  }

  @Property(tries = 30)
  void match_inACorridor_isUncertainAlongIt(
      @ForAll @DoubleRange(min = -3.0, max = 3.0) double direction,
      @ForAll @LongRange(min = 0, max = 1000) long seed) {
    Random random = new Random(seed);
    LocalMap map = new LocalMap(REACH + 5.0);
    Pose2 inRoom = new Pose2(0.0, 0.9, 0.1);
    Pose2 inMap = new Pose2(0.0, 0.0, 0.1 + direction); // the corridor points anywhere
    ScanPoints points = Room.corridor().points(inRoom, 10.0, NOISE, random);
    map.build(List.of(new KeyScan(inMap, points, null, 0.0)), inMap);
    ScanPoints scan = Room.corridor().points(new Pose2(0.3, 0.9, 0.1), 10.0, NOISE, random);
    double[] prior = Matrix3.inverse(Matrix3.ofSigmas(0.5, 0.5, 0.1));

    ScanMatcher.Match match = matcher.match(map, scan, inMap, prior, 0.0, 0.0);

    double[] after = Matrix3.inverse(Matrix3.plus(match.information(), prior));
    double[] along = Matrix3.rotated(after, -direction);
    assertThat(Math.sqrt(along[0])).as("along").isGreaterThan(0.3);
    assertThat(Math.sqrt(along[4])).as("across").isLessThan(0.05);
  }
}
