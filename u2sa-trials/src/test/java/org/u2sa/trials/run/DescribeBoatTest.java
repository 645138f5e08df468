package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;

/** {@code u2sa describe} of a system file whose services have devices. */
class DescribeBoatTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @TempDir private Path directory;

  private int run(String... arguments) {
    return Main.run(new PrintWriter(out), new PrintWriter(err), arguments);
  }

  private static String service(String className, String more) {
    return "<service class=\"" + className + "\"" + more + "/>";
  }

  @Test
  void describe_boat_tellsWhatIsStatedInNumbersAndWhatItsThrustersCanDoTogether()
      throws IOException {
    Files.writeString(
        directory.resolve("Compass.xml"),
        "<configuration><variable name=\"HEADING SIGMA\" type=\"double\" value=\"0.05\" unit=\"rad\"/>"
            + "<variable name=\"MOUNTED YAW\" type=\"double\" value=\"0.5\" unit=\"rad\"/></configuration>");
    for (int i = 1; i <= 2; i++) {
      Files.writeString(
          directory.resolve("Thruster" + i + ".xml"),
          "<configuration><variable name=\"SERVICE NAME\" type=\"string\" value=\"T"
              + i
              + "\"/><variable name=\"FULL THRUST\" type=\"double\" value=\"40\" unit=\"N\"/>"
              + "<variable name=\"REVERSE THRUST\" type=\"double\" value=\"30\" unit=\"N\"/>"
              + "<variable name=\"MOUNTED Y\" type=\"double\" value=\""
              + (i == 1 ? 0.25 : -0.25)
              + "\" unit=\"m\"/></configuration>");
    }
    Path file = directory.resolve("boat.xml");
    Files.writeString(
        file,
        "<system id=\"boat\">"
            + service("org.u2sa.device.CompassSensor", " configuration=\"Compass.xml\"")
            + service("org.u2sa.device.ThrusterActuator", " configuration=\"Thruster1.xml\"")
            + service("org.u2sa.device.ThrusterActuator", " configuration=\"Thruster2.xml\"")
            + service("org.u2sa.estimation.PassThroughStateEstimator", "")
            + service("org.u2sa.control.cascade.AllocatingControl", "")
            + "</system>");
    assertThat(run("describe", file.toString())).as(err.toString()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("CompassSensor measures the vehicle.")
        .contains("Control commands T1 and T2 to go there.")
        .containsPattern(
            "CompassSensor +.*HEADING SIGMA 0\\.05 rad, MOUNTED YAW 0\\.5 rad, .*COMPASS NMEA")
        .doesNotContain("MOUNTED PITCH")
        .containsPattern("T1: .*force \\(40.*exponent 2")
        .contains("in its weaker direction: surge 60.0 N, yaw 17.5 N m");
  }
}
