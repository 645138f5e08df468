package org.u2sa.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;

class DoctorTest {
  @TempDir private Path folder;

  private final StringWriter out = new StringWriter();

  private int run(String... arguments) {
    PrintWriter writer = new PrintWriter(out);
    return Main.run(writer, writer, arguments);
  }

  @Test
  void port_takenAndFree_areTold() throws Exception {
    MachineChecks checks = new MachineChecks(folder);
    int port;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = socket.getLocalPort();
      Finding taken = checks.port(port, false);
      assertThat(taken.grade()).isEqualTo(Finding.Grade.WARNING);
      assertThat(taken.advice()).contains("--port");
      assertThat(checks.port(port, true).grade()).isEqualTo(Finding.Grade.OK);
    }
    assertThat(checks.port(port, false).grade()).isEqualTo(Finding.Grade.OK);
  }

  @Test
  void serialPorts_noneAndSome_areTold() throws Exception {
    MachineChecks checks = new MachineChecks(folder);
    assertThat(checks.serialPorts().grade()).isEqualTo(Finding.Grade.OPTIONAL);
    Files.createFile(folder.resolve("tty1")); // a console, no serial port
    assertThat(checks.serialPorts().grade()).isEqualTo(Finding.Grade.OPTIONAL);
    Files.createFile(folder.resolve("ttyACM0"));
    assertThat(checks.serialPorts().found()).endsWith("ttyACM0");
    assertThat(checks.serialPorts().grade()).isEqualTo(Finding.Grade.OK);
  }

  @Test
  void tools_flightGearInTheGamesFolder_isFoundAsFlyFindsIt() throws Exception {
    Path program = folder.resolve("fgfs");
    Files.writeString(program, "#!/bin/sh\necho FlightGear 2020.3\n");
    Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
    Map<String, String> environment = Map.of("PATH", "");
    assertThat(new ToolChecks(new Programs(environment), environment, folder).all())
        .filteredOn(each -> each.subject().equals("FlightGear"))
        .singleElement()
        .satisfies(each -> assertThat(each.found()).endsWith("fgfs, FlightGear 2020.3"))
        .satisfies(each -> assertThat(each.grade()).isEqualTo(Finding.Grade.OK));
  }

  @Test
  void tools_foundOnThePath_sayTheirVersion() throws Exception {
    Path program = folder.resolve("adb");
    Files.writeString(program, "#!/bin/sh\necho\necho adb 1.2.3\n");
    Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
    Map<String, String> environment = Map.of("PATH", folder.toString());
    Path games = folder.resolve("none");
    var findings = new ToolChecks(new Programs(environment), environment, games).all();
    assertThat(findings)
        .filteredOn(each -> each.subject().equals("adb"))
        .singleElement()
        .satisfies(each -> assertThat(each.found()).endsWith("adb 1.2.3"))
        .satisfies(each -> assertThat(each.grade()).isEqualTo(Finding.Grade.OK));
    assertThat(findings)
        .filteredOn(each -> each.subject().equals("FlightGear"))
        .singleElement()
        .satisfies(each -> assertThat(each.grade()).isEqualTo(Finding.Grade.OPTIONAL))
        .satisfies(each -> assertThat(each.advice()).contains("install"));
  }

  @Test
  void tools_sdkFolderThatIsNone_isAWarning() throws Exception {
    Map<String, String> environment = Map.of("ANDROID_HOME", folder.toString());
    assertThat(new ToolChecks(new Programs(environment), environment).all())
        .anyMatch(each -> each.grade() == Finding.Grade.WARNING);
  }

  @Test
  void doctor_brokerNamedThatDoesNotAnswer_fails() throws Exception {
    int port;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = socket.getLocalPort();
    }
    assertThat(run("doctor", "--broker", "127.0.0.1:" + port)).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString()).contains("FAILURE  broker", "→ start the system");
  }

  @Test
  void doctor_json_namesEachCheck() {
    run("doctor", "--json");
    assertThat(out.toString()).contains("\"subject\" : \"Java\"", "\"grade\" : \"OK\"");
  }
}
