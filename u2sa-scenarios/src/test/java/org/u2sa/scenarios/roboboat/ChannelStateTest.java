package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.roboboat.gate.Gate;

class ChannelStateTest {
  @Test
  void known_buoySeenTwice_isWhereItIsKnownBest() {
    Point well = Point.of(89.5, -10.4, 0.0);
    Point fromAfar = Point.of(88.5, -8.2, 0.0);
    Point next = Point.of(84.5, -8.4, 0.0);

    assertThat(ChannelState.known(Stream.of(well, next, fromAfar))).containsExactly(well, next);
  }

  @Test
  void known_buoysOfAnyCourse_areAllThere() {
    for (long seed = 1; seed <= 200; seed++) {
      List<Gate> channel = BoatCourseGenerator.course(seed).channel();

      assertThat(ChannelState.known(channel.stream().map(Gate::left))).hasSameSizeAs(channel);
      assertThat(ChannelState.known(channel.stream().map(Gate::right))).hasSameSizeAs(channel);
    }
  }
}
