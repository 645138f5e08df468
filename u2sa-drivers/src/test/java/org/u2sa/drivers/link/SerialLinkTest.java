package org.u2sa.drivers.link;

import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.NeedsProgram;

/** A device on a serial line, which is a pair of pseudo terminals here. */
@NeedsProgram("socat")
class SerialLinkTest extends ByteLinkContract {
  @TempDir Path folder;

  @Override
  FarEnd device() throws Exception {
    return FarEnds.serial(folder.resolve("ttyTEST"));
  }
}
