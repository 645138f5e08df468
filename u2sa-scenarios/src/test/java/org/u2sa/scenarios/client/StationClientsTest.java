package org.u2sa.scenarios.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;

/** Ground stations and ROS tools as users have them operate demos in real time. */
@Tag("long")
@NeedsProgram(
    value = "python3",
    modules = {"MAVProxy", "mavsdk", "roslibpy"})
class StationClientsTest {
  private static final String STATIONS = "MAVLink ground stations";

  @TempDir private Path folder;

  private final String python =
      ForeignPrograms.ofThisMachine().required("python3", "MAVProxy", "mavsdk", "roslibpy");
  private final int port = FreePort.find();

  @Test
  void mavProxy_rover_setsParametersAndDrivesItsLoop() throws Exception {
    String link = "--mavlink=tcp:" + port + ",as=ardupilot";
    try (RunningDemo demo = new RunningDemo(folder, STATIONS, "ugv", link)) {
      demo.client(python, "mavproxy_drive.py", "tcp:127.0.0.1:" + port, "rover");
    }
  }

  @Test
  void mavProxy_cessna_fliesTenUploadedWaypoints() throws Exception {
    String link = "--mavlink=tcp:" + port + ",as=ardupilot";
    try (RunningDemo demo = new RunningDemo(folder, STATIONS, "cessna", link)) {
      demo.client(python, "mavproxy_drive.py", "tcp:127.0.0.1:" + port, "plane");
      await()
          .atMost(Duration.ofMinutes(10))
          .until(() -> demo.said().contains("10 of 10 waypoints captured"));
    }
  }

  @Test
  void mavsdk_rover_everyPluginWorks() throws Exception {
    String link = "--mavlink=tcp:" + port + ",logs=" + folder.resolve("out");
    try (RunningDemo demo = new RunningDemo(folder, STATIONS, "ugv", "--record", link)) {
      assertThat(demo.client(python, "mavsdk_operate.py", "tcpout://127.0.0.1:" + port))
          .contains("200 items up", "log of");
    }
  }

  @Test
  void mavsdk_delayAndLoss_missionAndMetadataAreComplete() throws Exception {
    int station = FreePort.find();
    try (RunningDemo demo =
        new RunningDemo(folder, STATIONS, "ugv", "--mavlink=udp:127.0.0.1:" + port)) {
      Process radio = demo.start(python, "lossy_link.py", "" + port, "" + station);
      try {
        demo.client(python, "mavsdk_operate.py", "udpin://127.0.0.1:" + station, "--lossy");
      } finally {
        ProcessTree.kill(radio);
      }
    }
  }

  @Test
  void roslibpy_rover_subscribesPublishesAndCallsServices() throws Exception {
    try (RunningDemo demo = new RunningDemo(folder, "rosbridge: ", "ugv", "--rosbridge=" + port)) {
      String token = new String(LocalToken.read("127.0.0.1", demo.port()).orElseThrow());
      demo.client(python, "roslibpy_client.py", "" + port, token);
    }
  }

  @Test
  void roslibpy_securedRover_obeysTheOperatorByTlsAndNotTheObserver() throws Exception {
    Path security = folder.resolve("security");
    run("security", "init", security.toString(), "--host=localhost");
    for (String user : List.of("operator", "observer")) {
      run(
          "security",
          "user",
          "add",
          user,
          "--role=" + user,
          "--system=ugv",
          "--dir=" + security,
          "--new-password-file=" + security.resolve(user));
    }
    String directory = "--set=CommunicationManager:SECURITY DIRECTORY=" + security;
    try (RunningDemo demo =
        new RunningDemo(folder, "rosbridge: wss:", "ugv", "--rosbridge=" + port, directory)) {
      demo.client(
          python,
          "roslibpy_secured.py",
          "" + port,
          security.resolve("operator").toString(),
          security.resolve("observer").toString());
    }
  }

  private void run(String... command) throws Exception {
    Process process = ForeignProgram.u2sa(folder.resolve("u2sa.txt"), command);
    assertThat(process.waitFor()).as(Files.readString(folder.resolve("u2sa.txt"))).isZero();
  }
}
