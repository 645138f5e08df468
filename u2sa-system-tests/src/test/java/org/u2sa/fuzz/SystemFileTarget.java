package org.u2sa.fuzz;

import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.BadInputException;

/** System files. */
public final class SystemFileTarget {
  private SystemFileTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      SystemFile system = SystemFile.read(file.path());
      Agreement.require(!system.services().isEmpty(), "services", system, "one at least");
      system.apart();
      for (SystemFile.Entry entry : system.services()) {
        Agreement.require(
            system.only(entry.simpleName()).services().size() == 1, "only", system, entry);
      }
    } catch (BadInputException e) {
      OneLine.require(e);
    }
  }
}
