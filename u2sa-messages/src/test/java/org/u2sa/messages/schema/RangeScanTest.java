package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;

class RangeScanTest {
  private static RangeScan scan() {
    return new RangeScan().sensorName("Laser").minRange(0.5).maxRange(5.0);
  }

  private static RangeScan.Beam beam(double angle, double range) {
    return new RangeScan.Beam(angle, OptionalDouble.of(range));
  }

  @Test
  void beams_even_haveTheirDirectionsAndNoEchoIsNone() {
    RangeScan scan =
        scan()
            .beams(
                -0.5,
                0.25,
                List.of(OptionalDouble.of(2.0), OptionalDouble.empty(), OptionalDouble.of(3.0)));
    assertThat(scan.beams())
        .containsExactly(
            beam(-0.5, 2.0), new RangeScan.Beam(-0.25, OptionalDouble.empty()), beam(0.0, 3.0));
    assertThat(scan.ranges()).containsExactly(2.0, 0.0, 3.0);
    assertThat(scan.returns()).containsExactly(true, false, true);
  }

  /** A range of 0 that was measured is not the same as none. */
  @Property
  void beams_uneven_comeBackFromTheWire(
      @ForAll List<@DoubleRange(min = -7.0, max = 7.0) Double> angles, @ForAll boolean[] returned)
      throws MalformedMessageException {
    List<RangeScan.Beam> beams = new ArrayList<>();
    for (int i = 0; i < angles.size(); i++) {
      boolean isReturned = returned.length > 0 && returned[i % returned.length];
      beams.add(
          isReturned
              ? beam(angles.get(i), Math.abs(angles.get(i)))
              : new RangeScan.Beam(angles.get(i), OptionalDouble.empty()));
    }
    RangeScan sent = scan().beams(beams);
    U2SAData read =
        new MessageCodec(StandardTypes.registry()).decode(sent.typeChain(), sent.serialize());
    assertThat(((RangeScan) read).beams()).isEqualTo(beams);
  }

  @Test
  void beams_listsOfDifferentLength_areAsManyAsTheShortest() {
    RangeScan scan = scan().beams(List.of(beam(0.0, 1.0), beam(0.1, 1.0)));
    RangeScan.TYPE.field("returns").orElseThrow().set(scan, List.of(true));
    assertThat(scan.beams()).containsExactly(beam(0.0, 1.0));
  }

  @Test
  void ranges_notFinite_areRefused() {
    RangeScan scan = scan();
    assertThatThrownBy(() -> scan.beams(List.of(beam(0.0, Double.POSITIVE_INFINITY))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("RangeScan.ranges")
        .hasMessageContaining("finite");
  }

  @Test
  void points_outsideItsRangesAndWithoutEcho_areNone() {
    RangeScan scan =
        scan()
            .x(1.0)
            .beams(
                List.of(
                    beam(0.0, 2.0),
                    beam(Math.PI / 2.0, 3.0),
                    beam(0.0, 0.4),
                    beam(0.0, 5.1),
                    new RangeScan.Beam(0.0, OptionalDouble.empty())));
    assertThat(scan.points()).hasSize(2);
    assertThat(scan.points().get(0).distanceTo(Point.of(3.0, 0.0, 0.0))).isLessThan(1.0e-9);
    assertThat(scan.points().get(1).distanceTo(Point.of(1.0, 3.0, 0.0)))
        .as("to the left")
        .isLessThan(1.0e-9);
  }

  @Test
  void points_sensorTurned_areInBody() {
    RangeScan left = scan().psi(Math.PI / 2.0).beams(List.of(beam(0.0, 2.0)));
    assertThat(left.points().get(0).y()).as("to the left").isCloseTo(2.0, within(1.0e-9));
    RangeScan up = scan().theta(Math.PI / 2.0).beams(List.of(beam(0.0, 2.0)));
    assertThat(up.points().get(0).z()).as("above").isCloseTo(-2.0, within(1.0e-9));
    RangeScan rolled = scan().phi(Math.PI / 2.0).beams(List.of(beam(Math.PI / 2.0, 2.0)));
    assertThat(rolled.points().get(0).z()).as("left side down").isCloseTo(2.0, within(1.0e-9));
  }

  @Test
  void points_placeInAnotherFrame_areRefused() {
    RangeScan scan = scan().referenceFrame(ReferenceFrame.LOCAL_ENU).beams(List.of(beam(0.0, 2.0)));
    assertThatThrownBy(scan::points)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("a scan in LOCAL_ENU has no points: expected BODY");
  }
}
