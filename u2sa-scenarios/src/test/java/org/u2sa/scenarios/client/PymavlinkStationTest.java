package org.u2sa.scenarios.client;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;

/**
 * The outside judge of the MAVLink bridge: pymavlink connects to a rover as QGroundControl does.
 */
@NeedsProgram(value = "python3", modules = "pymavlink.mavftp")
@Timeout(600)
class PymavlinkStationTest {
  @TempDir private Path folder;

  @Test
  void connect_asQGroundControl_everythingIsAnsweredAndConsistent() throws Exception {
    String python = ForeignPrograms.ofThisMachine().required("python3", "pymavlink.mavftp");
    int port = FreePort.find();
    String link = "tcp:" + port + ",logs=" + folder.resolve("out");
    try (RunningDemo demo =
        new RunningDemo(
            folder, "MAVLink ground stations", "ugv", "--record", "--mavlink=" + link)) {
      assertThat(demo.client(python, "qgc_connect.py", "tcp:127.0.0.1:" + port))
          .containsPattern("modes [56]\n") // 6 once the planner is known: another class of it
          .contains("mission MISSION_COUNT 24", "intrusions refused", "done");
    }
  }

  @Tag("long")
  @Test
  void connect_bySerialLine_everythingIsAnsweredAndConsistent() throws Exception {
    ForeignPrograms programs = ForeignPrograms.ofThisMachine();
    String python = programs.required("python3", "pymavlink.mavftp");
    int port = FreePort.find();
    Path line = folder.resolve("tty");
    Process socat =
        new ProcessBuilder(
                programs.required("socat"),
                "pty,raw,echo=0,link=" + line,
                "tcp-listen:" + port + ",bind=127.0.0.1,reuseaddr")
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("socat.txt").toFile())
            .start();
    String link = "serial:" + line + ",baud=921600,logs=" + folder.resolve("out");
    try (RunningDemo demo =
        new RunningDemo(
            folder, "MAVLink ground stations", "ugv", "--record", "--mavlink=" + link)) {
      assertThat(demo.client(python, "qgc_connect.py", "tcp:127.0.0.1:" + port))
          .contains("mission MISSION_COUNT 24", "rally MISSION_COUNT 0", "done");
    } finally {
      ProcessTree.kill(socat);
    }
  }
}
