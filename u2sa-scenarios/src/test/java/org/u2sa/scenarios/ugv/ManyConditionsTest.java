package org.u2sa.scenarios.ugv;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.scenarios.run.CommandLineRun;

/** All that docs/ugv.md says that the motors can do, over several seeds. */
@Tag("long")
class ManyConditionsTest {
  @TempDir private Path directory;

  static List<String> conditions() {
    List<String> all = new ArrayList<>();
    for (int seed = 21; seed <= 23; seed++) {
      for (int mismatch : new int[] {0, 5, 15, 30, -50}) {
        for (int payload : new int[] {0, 20, 50}) {
          String drive = " --mismatch " + mismatch + " --payload " + payload + " --seed " + seed;
          all.add("--control pursuit" + drive);
          all.add("--control proportional" + drive);
          if (Math.abs(mismatch) <= 30) {
            all.add("--control pursuit --slope 5" + drive);
          }
          if (Math.abs(mismatch) <= 30 && payload <= 20) {
            all.add("--control pursuit --slope 10" + drive);
          }
        }
      }
      for (String surface : new String[] {"concrete", "field"}) {
        all.add("--surface " + surface + " --mismatch 30 --payload 50 --seed " + seed);
      }
    }
    return all;
  }

  @ParameterizedTest
  @MethodSource("conditions")
  void demo_unlikeMotorsLoadsAndGround_holdsTheLine(String options) {
    ConditionsTest.requireHeld(
        CommandLineRun.demo("ugv", directory, (options + " --loops 1").split(" ")));
  }
}
