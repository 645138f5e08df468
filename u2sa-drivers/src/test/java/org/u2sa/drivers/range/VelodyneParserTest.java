package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class VelodyneParserTest {
  private final VelodyneParser parser = new VelodyneParser();

  private List<Point> heard(byte[] bytes) {
    parser.accept(bytes, bytes.length, 9);
    assertThat(parser.latest().orElseThrow().measuredAtMicros()).isEqualTo(9);
    return parser.latest().orElseThrow().points();
  }

  @Test
  void accept_postToTheRight_isOneClusterOfPointsToTheRight() {
    List<Point> points =
        heard(
            VelodynePackets.revolutions(
                3,
                (azimuth, elevation) ->
                    Math.abs(azimuth - 90.0) < 0.45 && elevation == 1.0 ? 5.0 : 0.0));

    assertThat(points)
        .as("firings at 89.6, 89.8, 90, 90.2 and 90.4 deg")
        .hasSize(5)
        .allSatisfy(
            point -> {
              assertThat(point.x()).isCloseTo(0.0, within(0.04));
              assertThat(point.y()).as("left").isCloseTo(-4.999, within(0.002));
              assertThat(point.z()).as("down").isCloseTo(-0.0873, within(0.0005));
            });
    assertThat(parser.refused()).isZero();
  }

  @Test
  void accept_secondFiringOfABlock_isInterpolated() {
    List<Point> points =
        heard(
            VelodynePackets.revolutions(
                3,
                (azimuth, elevation) ->
                    Math.abs(azimuth - 45.0) < 0.05 && elevation == -15.0 ? 10.0 : 0.0));

    assertThat(points).as("of the block at 44.8 deg").hasSize(1);
    assertThat(Math.toDegrees(Math.atan2(-points.get(0).y(), points.get(0).x())))
        .isCloseTo(45.0, within(1e-6));
  }

  @Test
  void accept_firstRevolutionFromItsMiddle_isNotACloud() {
    byte[] bytes = VelodynePackets.revolutions(2, (azimuth, elevation) -> 3.0);
    byte[] half = Arrays.copyOfRange(bytes, 40 * 1206, bytes.length);

    parser.accept(half, half.length, 9);

    assertThat(parser.latest()).isEmpty();
  }

  @Property(tries = 50)
  void accept_garbageBeforeAndPiecesOfAnySize_findsTheNextWholeRevolution(
      @ForAll @IntRange(max = 3000) int garbage,
      @ForAll @IntRange(min = 1, max = 5000) int piece,
      @ForAll long seed) {
    byte[] noise = new byte[garbage];
    new Random(seed).nextBytes(noise);
    VelodyneParser fresh = new VelodyneParser();
    fresh.accept(noise, noise.length, 1);
    byte[] bytes = VelodynePackets.revolutions(3, (azimuth, elevation) -> 3.0);
    for (int from = 0; from < bytes.length; from += piece) {
      byte[] part = Arrays.copyOfRange(bytes, from, Math.min(bytes.length, from + piece));
      fresh.accept(part, part.length, 2);
    }

    assertThat(fresh.latest().orElseThrow().points()).hasSize(900 * 32);
  }
}
