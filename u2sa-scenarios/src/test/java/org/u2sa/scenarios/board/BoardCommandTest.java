package org.u2sa.scenarios.board;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;
import org.u2sa.testkit.Repository;

/** {@code u2sa board} as a user runs it, driven by a program in Python and attacked by others. */
class BoardCommandTest {
  private static final String UGV = "config/ugv/vehicle.xml";
  private static final int GREETING = 29;

  @TempDir private Path folder;

  private static Process python(int port, int seconds, String... more) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                ForeignPrograms.ofThisMachine().required("python3"),
                Repository.root()
                    .resolve("u2sa-scenarios/src/test/python/ioio_client.py")
                    .toString(),
                "127.0.0.1",
                "" + port,
                "" + seconds));
    command.addAll(List.of(more));
    return new ProcessBuilder(command).redirectErrorStream(true).start();
  }

  private static JsonNode driven(Process client) throws IOException {
    BufferedReader said = client.inputReader(UTF_8);
    String line = said.readLine();
    assertThat(line).startsWith("{");
    return new ObjectMapper().readTree(line);
  }

  @ParameterizedTest
  @CsvSource(UGV + ", 90")
  @NeedsProgram("python3")
  void board_pythonClient_drivesTheVehicleAndMotorsStopWhenItEnds(String vehicle, int heading)
      throws Exception {
    try (ServedBoard board =
        new ServedBoard(
            folder,
            vehicle,
            "--start",
            "-81.05,29.19," + heading,
            "--status",
            "--out",
            folder.toString())) {
      Process client = python(board.port(), 4);
      JsonNode seen = driven(client);

      assertThat(seen.path("board").asText()).isEqualTo("SPRK0020IOIO0402IOIO0506");
      assertThat(seen.path("metres").asDouble()).isBetween(1.0, 8.0);
      client.getOutputStream().close();
      assertThat(client.waitFor()).isZero();
      board.awaitSaid("has left: ");
      board.awaitSaid("no signal; contacts 0; host none");
      assertThat(board.end()).isEqualTo(143);
    }
    List<String> track = Files.readAllLines(folder.resolve("track.csv"));
    assertThat(track.get(0)).startsWith("time_s,longitude_deg,latitude_deg");
    assertThat(track).anyMatch(line -> line.endsWith(",MOVES"));
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource("config/vehicles/otter.xml, 0")
  @NeedsProgram("python3")
  void board_pythonClientOfABoat_drivesItAndMotorsStopWhenItEnds(String vehicle, int heading)
      throws Exception {
    board_pythonClient_drivesTheVehicleAndMotorsStopWhenItEnds(vehicle, heading);
  }

  @Test
  @NeedsProgram("python3")
  void board_clientStopped_motorsLoseTheirPulses() throws Exception {
    try (ServedBoard board = new ServedBoard(folder, UGV, "--status", "--silent-after", "1")) {
      Process client = python(board.port(), 2);
      driven(client); // and says nothing more, with pulses of 60 %

      board.awaitSaid("has left: it was silent for too long");
      board.awaitSaid("LEFT MOTOR no signal, RIGHT MOTOR no signal; contacts 0; host none");
      ProcessTree.end(client);
    }
  }

  @Test
  void board_garbage_endsEachSessionInOneLine() throws Exception {
    Random random = new Random(1);
    try (ServedBoard board = new ServedBoard(folder, UGV)) {
      for (int i = 0; i < 5; i++) {
        try (Socket socket = board.connect()) {
          socket.getInputStream().readNBytes(GREETING);
          byte[] garbage = new byte[100_000];
          random.nextBytes(garbage);
          garbage[0] = (byte) 0xEE;
          write(socket, garbage);
          awaitEnd(socket);
        }
        int count = i + 1;
        await().until(() -> board.lines("has left: the board rejected") == count);
      }
      assertThat(board.said()).doesNotContain("Exception");
      assertGreeted(board);
    }
  }

  private static void write(Socket socket, byte[] bytes) throws IOException {
    try {
      OutputStream out = socket.getOutputStream();
      out.write(bytes);
    } catch (SocketException e) {
      assertThat(socket.isConnected()).isTrue(); // the board has hung up meanwhile
    }
  }

  private static void awaitEnd(Socket socket) throws IOException {
    try {
      InputStream in = socket.getInputStream();
      in.transferTo(OutputStream.nullOutputStream());
    } catch (SocketException e) {
      assertThat(e).hasMessageContaining("eset"); // connection reset
    }
  }

  private static void assertGreeted(ServedBoard board) throws IOException {
    try (Socket socket = board.connect()) {
      byte[] greeting = socket.getInputStream().readNBytes(GREETING);
      assertThat(new String(greeting, 1, 4, UTF_8)).isEqualTo("IOIO");
    }
  }

  @Test
  void board_secondClient_isRefusedAndTheFirstGoesOn() throws Exception {
    try (ServedBoard board = new ServedBoard(folder, UGV);
        Socket first = board.connect()) {
      first.getInputStream().readNBytes(GREETING);
      try (Socket second = board.connect()) {
        assertThat(second.getInputStream().readAllBytes()).isEmpty();
      }
      board.awaitSaid("host refused, another host is connected");

      first.getOutputStream().write(0x23); // SYNC
      assertThat(first.getInputStream().read()).isEqualTo(0x23);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "0.0.0.0, opens the board to a network",
    "nowhere.invalid, expected ADDRESS or ADDRESS:PORT",
    "127.0.0.1:99999, expected ADDRESS or ADDRESS:PORT"
  })
  void board_addressNotAllowed_isRefusedWithTheReason(String address, String words) {
    CommandLineRun run =
        CommandLineRun.of(
            "board", "--vehicle", Repository.root().resolve(UGV).toString(), "--listen", address);

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains(words);
  }

  private static String command(String... arguments) {
    CommandLineRun run = CommandLineRun.of(arguments);
    assertThat(run.exitCode()).as(run.said()).isZero();
    return run.out();
  }

  private Path user(String name, String role) {
    Path password = folder.resolve(name + ".password");
    command(
        "security",
        "user",
        "add",
        name,
        "--role",
        role,
        "--system",
        "*",
        "--new-password-file",
        password.toString(),
        "--dir",
        folder.resolve("security").toString());
    return password;
  }

  @Test
  @NeedsProgram("python3")
  void board_secured_servesItsUsersOnlyOverTls() throws Exception {
    Path security = folder.resolve("security");
    command("security", "init", security.toString(), "--host", "127.0.0.1");
    Path pilot = user("pilot", "control");
    Path screen = user("screen", "observer");
    String authority = security.resolve("ca.pem").toString();
    try (ServedBoard board =
        new ServedBoard(folder, UGV, "--security", security.toString(), "--status")) {
      Process observer = python(board.port(), 1, authority, "screen", screen.toString());
      assertThat(new String(observer.getInputStream().readAllBytes(), UTF_8))
          .contains("REFUSED user, password or role");
      Process stranger = python(board.port(), 1, authority, "stranger", screen.toString());
      assertThat(new String(stranger.getInputStream().readAllBytes(), UTF_8))
          .contains("REFUSED user, password or role");
      try (Socket plain = board.connect()) {
        write(plain, "LOGIN pilot x\n".getBytes(UTF_8));
        awaitEnd(plain);
      }

      Process client = python(board.port(), 1, authority, "pilot", pilot.toString());
      assertThat(driven(client).path("metres").asDouble()).isPositive();
      command("security", "user", "remove", "pilot", "--dir", security.toString());
      board.awaitSaid("its user is no longer admitted");
      board.awaitSaid("no signal; contacts 0; host none");
      ProcessTree.end(client);
    }
  }

  @Test
  @NeedsProgram("socat")
  void board_serialPorts_speakNmeaAndGoWithTheProgram() throws Exception {
    Path ports = folder.resolve("ports");
    Path gps = ports.resolve("gps");
    try (ServedBoard board = new ServedBoard(folder, UGV, "--serial", ports.toString())) {
      board.awaitSaid("serial:" + gps);
      await().until(() -> Files.exists(gps));
      for (int opened = 0; opened < 2; opened++) {
        await()
            .ignoreExceptions()
            .until(
                () -> {
                  try (BufferedReader lines = Files.newBufferedReader(gps)) {
                    lines.readLine();
                    return lines.readLine().startsWith("$GP");
                  }
                });
      }
      assertThat(board.end()).isEqualTo(143);
    }
    assertThat(gps).doesNotExist();
  }
}
