package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Paths;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;

class MissionTest {
  /** Reads the goals and home of a mission given without its root element. */
  static Mission mission(String content) {
    String xml = "<mission>\n" + content + "\n</mission>";
    return Mission.parse(
        XmlReader.read(
            new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml", "mission"),
        StandardTypes.registry(),
        OptionalDouble.of(80.0));
  }

  private static Waypoint only(String content) {
    return (Waypoint) mission(content).goals().get(0);
  }

  @Test
  void parse_snippetOfThesis32_3_2_nameNextAndReferenceAreRead() {
    Mission mission =
        mission(
            "<waypoint><name>1</name><next>2</next><reference>Global</reference><x>10</x><y>15</y></waypoint>"
                + "<waypoint><name>2</name><x>11</x><y>15</y></waypoint>");
    Waypoint first = (Waypoint) mission.goals().get(0);

    assertThat(first.uid()).isEqualTo("1");
    assertThat(first.next()).containsExactly("2");
    assertThat(first.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(first.x()).hasValue(10.0);
    assertThat(first.y()).hasValue(15.0);
    assertThat(first.z()).isEmpty();
    assertThat(first.horizontalThreshold()).isEqualTo(80.0);
    assertThat(mission.home()).isEmpty();
    assertThat(mission.warnings()).isEmpty();
  }

  @Test
  void parse_snippetOfThesis45_2_3_namesAreNumbersInTheFile() {
    String snippet = "<waypoint>\n<y>37.466189</y>\n<x>-121.134548</x>\n<z>3000</z>\n</waypoint>";
    Mission mission = mission(snippet + snippet);

    assertThat(mission.goals()).extracting(GoalInformation::uid).containsExactly("1", "2");
    assertThat(((Waypoint) mission.goals().get(1)).z()).hasValue(3000.0);
    assertThat(mission.goals()).allMatch(GoalInformation::isFrozen);
  }

  @Test
  void parse_units_areConverted() {
    Waypoint waypoint =
        only(
            "<Waypoint><x unit=\"rad\">0.1</x><y>15</y><z unit=\"ft\">1000</z><psi unit=\"deg\">90</psi>"
                + "<speed unit=\"kt\">100</speed><time unit=\"min\">2</time></Waypoint>");

    assertThat(waypoint.x().orElseThrow()).isCloseTo(Math.toDegrees(0.1), within(1.0e-9));
    assertThat(waypoint.z().orElseThrow()).isCloseTo(304.8, within(1.0e-9));
    assertThat(waypoint.psi().orElseThrow()).isCloseTo(Math.PI / 2.0, within(1.0e-9));
    assertThat(waypoint.speed().orElseThrow()).isCloseTo(51.444, within(0.001));
    assertThat(waypoint.time()).hasValue(120.0);
  }

  @Test
  void parse_unitBeforeReference_unitIsThatOfTheFrame() {
    Waypoint waypoint =
        only("<waypoint><x unit=\"ft\">10</x><y>15</y><reference>local enu</reference></waypoint>");

    assertThat(waypoint.x().orElseThrow()).isCloseTo(3.048, within(1.0e-9));
    assertThat(waypoint.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_ENU);
  }

  @ParameterizedTest
  @ValueSource(strings = {"<next>b</next><next>c</next>", "<next>b, c</next>"})
  void parse_severalNext_commaOrRepeated(String next) {
    Mission mission =
        mission(
            "<waypoint><name>a</name>"
                + next
                + "<x>1</x></waypoint>"
                + "<waypoint><name>b</name><x>2</x></waypoint><waypoint><name>c</name><x>3</x></waypoint>");

    assertThat(mission.goals().get(0).next()).isEqualTo(List.of("b", "c"));
  }

  @Test
  void parse_home_headingIsInDegreesAndWrapped() {
    Home home =
        mission(
                "<home><x>8</x><y>50</y><z unit=\"ft\">100</z><psi>-90</psi></home><waypoint><x>1</x></waypoint>")
            .home()
            .orElseThrow();

    assertThat(home.geodetic().orElseThrow().latitudeDeg()).isEqualTo(50.0);
    assertThat(home.z().orElseThrow()).isCloseTo(30.48, within(1.0e-9));
    assertThat(home.headingRad().orElseThrow()).isCloseTo(1.5 * Math.PI, within(1.0e-9));
  }

  @Test
  void parse_goalThatNothingLeadsTo_isWarnedOf() {
    Mission mission =
        mission(
            "<waypoint><name>a</name><next>a</next><x>1</x></waypoint>\n<waypoint><name>b</name><x>2</x></waypoint>");

    assertThat(mission.warnings())
        .contains(
            "m.xml, line 3, <waypoint>: no <next> leads to goal \"b\" from the first; it is pursued on command only");
  }

  @ParameterizedTest
  @ValueSource(strings = {"mission", "keflavik", "thesis"})
  void load_missionOfTheRepository_isReadWithoutWarning(String name) {
    Mission mission = Mission.load(Paths.get("../missions/cessna/" + name + ".xml"));

    assertThat(mission.goals()).hasSizeGreaterThan(2);
    assertThat(mission.home()).isPresent();
    assertThat(mission.warnings()).isEmpty();
  }
}
