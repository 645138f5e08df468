package org.u2sa.sim.jsbsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/** The function language, and what a file may not say. */
class JsbsimReadingTest {
  private static XmlElement xml(String text, String root) {
    return XmlReader.read(
        new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "test.xml", root);
  }

  private static double value(String operations) {
    PropertyTree properties = new PropertyTree(Map.of("a/x", 2.0, "a/y", -0.5));
    String text = "<function name=\"f\">" + operations + "</function>";
    return new FunctionReader(properties).function(xml(text, "function")).getAsDouble();
  }

  @ParameterizedTest
  @CsvSource({
    "<sum><value>1</value><p>a/x</p><p>-a/x</p></sum>, 1",
    "<difference><value>1</value><p>a/x</p><p>a/y</p></difference>, -0.5",
    "<quotient><p>a/x</p><v>4</v></quotient>, 0.5",
    "<pow><p>a/x</p><v>3</v></pow>, 8",
    "<abs><property>a/y</property></abs>, 0.5",
    "<cos><pi/></cos>, -1",
    "<todegrees><asin><p>a/y</p></asin></todegrees>, -30",
    "<ifthen><lt><p>a/y</p><v>0</v></lt><v>7</v><v>9</v></ifthen>, 7",
    "<max><v>1</v><p>a/x</p><v>-3</v></max>, 2",
    "<avg><v>1</v><p>a/x</p><v>3</v></avg>, 2"
  })
  void function_operations_haveTheirValue(String operations, double expected) {
    assertThat(value(operations)).isCloseTo(expected, within(1e-12));
  }

  @ParameterizedTest
  @CsvSource({"-1, 0, 10", "0.5, 0, 15", "5, 0, 20", "0.5, 1, 20", "0.5, 9, 25", "2, 2, 30"})
  void table_rowAndColumn_isLinearBetweenAndConstantBeyond(
      double row, double column, double expected) {
    XmlElement table =
        xml("<table><tableData> 0 2 \n 0 10 20 \n 1 20 30 </tableData></table>", "table");
    assertThat(LookupTable.read(table).at(row, column)).isCloseTo(expected, within(1e-12));
  }

  private static Path changed(Path folder, String old, String now) throws IOException {
    Path original = JsbsimFlightTest.trainerFile();
    Files.createDirectories(folder.resolve("engine"));
    for (String part : new String[] {"four90.xml", "wood68.xml"}) {
      Files.copy(
          original.resolveSibling("engine").resolve(part), folder.resolve("engine").resolve(part));
    }
    String text = Files.readString(original);
    assertThat(text).contains(old);
    return Files.writeString(folder.resolve("trainer.xml"), text.replace(old, now));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<property>aero/bi2vel</property> | <property>aero/bi3vel</property>"
            + " | line 227, <property>: property \"aero/bi3vel\" is never set",
        "<difference><value>1 | <integral><value>1 | not well-formed XML",
        "<abs><property>aero/beta-rad</property></abs> | <erf><property>aero/beta-rad</property></erf>"
            + " | <erf>: unknown element in <product>; expected abs, acos",
        "<wingspan unit=\"FT\"> | <wingspan unit=\"LBS\"> | <wingspan>: unit \"LBS\": expected FT",
        "<engine file=\"four90\"> | <engine file=\"four91\"> | file \"four91\" is missing",
        "<pure_gain name=\"Left Aileron Control\"> | <pid name=\"a\"/><pure_gain name=\"b\">"
            + " | <pid>: unknown element in <channel>",
        "<axis name=\"LIFT\"> | <axis name=\"UP\"> | axis \"UP\" in frame \"BODY\": expected one of AXIAL",
        "<emptywt unit=\"LBS\"> 750 | <emptywt unit=\"LBS\"> much | \"much\": expected a number"
      })
  void read_somethingWrong_namesLineAndExpectation(
      String old, String now, String message, @TempDir Path folder) throws IOException {
    Path file = changed(folder, old, now);
    assertThatThrownBy(() -> JsbsimAircraft.read(file, Map.of()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("trainer.xml")
        .hasMessageContaining(message);
  }

  @Test
  void read_functionsThatTakeMinutes_areRefused(@TempDir Path folder) throws IOException {
    String many = "<function><value>1</value></function>".repeat(10_000);
    Path file = changed(folder, "<aerodynamics>", "<aerodynamics>" + many);
    assertThatThrownBy(() -> JsbsimAircraft.read(file, Map.of()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("trainer.xml")
        .hasMessageContaining("elements with engines and systems; expected at most 20000");
  }

  @Test
  void read_propertyOfTheVehicleFile_replacesTheMissingOne(@TempDir Path folder)
      throws IOException {
    Path file =
        changed(folder, "<input>fcs/pitch-trim-cmd-norm</input>", "<input>ap/elevator_cmd</input>");
    assertThat(JsbsimAircraft.read(file, Map.of("ap/elevator_cmd", 0.0)).actuators())
        .contains("ELEVATOR");
  }

  @Test
  void step_kinematicFlaps_takesTheTimesOfTheSettings() {
    PropertyTree properties = new PropertyTree(Map.of("fcs/flap-cmd-norm", 1.0));
    FlightControl control = new FlightControl(properties, new FunctionReader(properties));
    control.read(
        xml(
            "<system><kinematic name=\"Flaps\"><input>fcs/flap-cmd-norm</input><traverse>"
                + "<setting><position>0</position><time>0</time></setting>"
                + "<setting><position>10</position><time>2</time></setting>"
                + "<setting><position>35</position><time>5</time></setting>"
                + "</traverse><output>fcs/flap-pos-deg</output></kinematic></system>",
            "system"));
    control.step(1.0);
    assertThat(properties.get("fcs/flap-pos-deg")).isCloseTo(5.0, within(1e-9));
    control.step(2.0);
    assertThat(properties.get("fcs/flap-pos-deg")).isCloseTo(15.0, within(1e-9));
    assertThat(properties.get("fcs/flap-pos-rad")).isCloseTo(Math.toRadians(15.0), within(1e-9));
    properties.set("fcs/flap-cmd-norm", 0.0);
    control.step(100.0);
    assertThat(properties.get("fcs/flap-pos-deg")).isZero();
  }
}
