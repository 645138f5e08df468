package org.u2sa.fuzz;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.world.xml.WorldFile;

/** World files. */
public final class WorldTarget {
  private static final MessageTypes TYPES = MessageTypes.discovered();

  private WorldTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      for (ObjectDescription object : WorldFile.load(file.path(), TYPES).objects()) {
        Agreement.require(object.serialize().length > 0, "bytes", 0, "some");
        Agreement.require(!object.uid().isEmpty(), "uid", object.uid(), "some");
        boolean onEarth = object.referenceFrame().equals(ReferenceFrame.GLOBAL);
        if (onEarth) {
          double distance = object.distanceTo(object.center());
          Agreement.require(distance >= 0.0, "distance", distance, "not negative");
        }
      }
    } catch (BadInputException e) {
      OneLine.require(e);
    }
  }
}
