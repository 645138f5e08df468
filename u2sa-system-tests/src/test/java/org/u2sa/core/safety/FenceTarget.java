package org.u2sa.core.safety;

import org.u2sa.fuzz.InputFile;
import org.u2sa.fuzz.OneLine;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;

/** Fence files, for the fuzzer: read, drawn in, and asked about a place. */
public final class FenceTarget {
  private static final double MARGIN_M = 50.0;

  private FenceTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      Fence fence = FenceReader.read(file.path());
      fence.allows(Point.of(0.0, 0.0, 0.0));
      drawnIn(fence);
    } catch (BadInputException e) {
      OneLine.require(e);
    }
  }

  private static void drawnIn(Fence fence) {
    Fence smaller;
    try {
      smaller = fence.drawnInBy(MARGIN_M);
    } catch (IllegalArgumentException nothingLeft) {
      return;
    }
    Point place = Point.of(10.0, 10.0, 0.0);
    if (smaller.allows(place) && !fence.allows(place)) {
      throw new AssertionError("a margin made the fence larger");
    }
  }
}
