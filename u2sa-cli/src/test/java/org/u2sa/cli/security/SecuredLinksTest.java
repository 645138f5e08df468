package org.u2sa.cli.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.testkit.FreePort;

/** MAVLink links of a system whose broker admits users only. */
class SecuredLinksTest extends CommandFixture {
  @TempDir private Path folder;

  @Test
  @Timeout(120)
  void run_mavlinkLinkBesideUsers_isRefusedAtOnceAndNotInFlight() throws IOException {
    SecurityDirectory directory = new SecurityDirectory(folder.resolve("security"));
    assertThat(u2sa("security", "init", directory.path().toString())).isEqualTo(ExitCode.DONE);
    Files.writeString(
        folder.resolve("Manager.xml"),
        "<configuration><variable name=\"SECURITY DIRECTORY\" type=\"string\" value=\""
            + directory.path()
            + "\"/><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + FreePort.find()
            + "\"/></configuration>");
    Path system =
        Files.writeString(
            folder.resolve("system.xml"),
            "<system id=\"boat\"><communication configuration=\"Manager.xml\"/>"
                + "<service class=\"org.u2sa.core.health.HealthMonitor\"/></system>");
    String logs = folder.resolve("logs").toString();
    String link = "tcp:" + FreePort.find();

    assertThat(u2sa("run", system.toString(), "--logs", logs, "--mavlink", link))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("has a SECURITY DIRECTORY; expected ./u2sa mavlink");
  }
}
