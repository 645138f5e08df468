package org.u2sa.messages;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.ReferenceFrame;

/** What the third format brought. */
final class GoldenFormat3 {
  private GoldenFormat3() {}

  static void addTo(GoldenMessages golden) {
    golden.add(
        "RangeScan",
        new RangeScan()
            .sensorName("Laser")
            .x(0.5)
            .y(-0.25)
            .z(-0.125)
            .phi(0.0625)
            .theta(-0.03125)
            .psi(1.5)
            .minRange(0.25)
            .maxRange(5.5)
            .timeIncrement(0.0009765625)
            .beams(
                -0.5,
                0.25,
                List.of(OptionalDouble.of(2.5), OptionalDouble.empty(), OptionalDouble.of(3.75))));
    golden.add(
        "RangeScan-uneven",
        new RangeScan()
            .sensorName("Laser")
            .referenceFrame(ReferenceFrame.BODY_FRD)
            .maxRange(12.0)
            .beams(
                List.of(
                    new RangeScan.Beam(0.0, OptionalDouble.empty()),
                    new RangeScan.Beam(-0.015625, OptionalDouble.of(2.5)))));
    golden.add("RangeScan-empty", new RangeScan().sensorName("Laser").maxRange(12.0));
  }
}
